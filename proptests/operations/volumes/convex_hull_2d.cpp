// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/convex_hull_2d.h"

#include "proptests/hull_laws.h"
#include "proptests/polygons_from_elsewhere.h"

namespace touchstone::proptests::convex_hull_2d_tests {
namespace {

using Row = rows::convex_hull_2d;
using Points = Row::Points;

/// The squared cosine of an angle with its sign, exactly.
Rational squared_cosine(const Vector2<Rational>& v, const Vector2<Rational>& w) {
  const Rational product = dot(v, w);
  return Rational(product * abs(product) / (dot(v, v) * dot(w, w)));
}

bool moderate(const Rational& x) {
  return sgn(x) == 0 || (abs(x) >= power_of_two(-200) && abs(x) <= power_of_two(200));
}

/// Whether rounding can decide nothing wrong in the slide's formula, by the bounds of
/// reference/volumes/convex_hull_2d.h: walks round the hull with it.
bool beyond_margins(const Points& points, const ConvexHull2& hull) {
  if (!hull.polygon) return false;
  std::vector<Index> ring = *hull.polygon;
  const auto higher = [&](Index i, Index k) { return points[i].y < points[k].y; };
  std::rotate(ring.begin(), std::max_element(ring.begin(), ring.end(), higher), ring.end());
  for (const Point2d& p : points) {
    if (p.y == points[ring[0]].y && !(p == points[ring[0]])) return false;
  }
  const Rational room = 40 * unit();
  Vector2<Rational> before{-1, 0};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto from_here = [&, p = points[ring[k]]](const Point2d& q) {
      return Vector2<Rational>{Rational(exact(q.x) - exact(p.x)), Rational(exact(q.y) - exact(p.y))};
    };
    const Point2d next = points[ring[(k + 1) % ring.size()]];
    const Vector2<Rational> edge = from_here(next);
    const Rational most = squared_cosine(before, edge);
    for (const Point2d& q : points) {
      const Vector2<Rational> v = from_here(q);
      if (!moderate(v.x) || !moderate(v.y)) return false;
      if (q == points[ring[k]]) continue;
      if (!(q == next) && squared_cosine(before, v) + room >= most) return false;
    }
    before = edge;
  }
  return true;
}

}  // namespace

TEST_CASE("convex_hull_2d: the hull does not hang on the order of the points, and every corner is needed") {
  hulls_are_hulls<Row>();
}

TEST_CASE("convex_hull_2d: symmetries, integer maps and powers of two carry hulls to hulls") {
  law<Row>("images", [](const auto& ask, const auto& asked) {
    const auto carried = [&](const Affine& map) {
      const auto image = map(asked);
      const auto expected = corners_of(std::get<0>(image), ask(asked)),
                 found = corners_of(std::get<0>(image), ask(image));
      return same_points(expected, found);
    };
    return std::all_of(axis_symmetries.begin(), axis_symmetries.end(), carried) &&
           (!on_lattice(asked) || std::all_of(integer_maps.begin(), integer_maps.end(), carried));
  });
  law<Row>("scales", scales<Row>);
}

ROBUST_LAW("convex_hull_2d: robust begins with the lexicographically least point, and names the first of equal ones",
           points) {
  const ConvexHull2 hull = ask(asked);
  std::vector<Index> ring = hull.polygon.value_or(std::vector<Index>());
  if (hull.point) ring = {*hull.point};
  if (hull.segment) ring = {hull.segment->i, hull.segment->j};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2d &p = points[i], &least = points[ring[0]];
    if (p.x < least.x || (p.x == least.x && p.y < least.y)) return false;
    for (const Index k : ring) {
      if (p == points[k] && i < k) return false;
    }
  }
  return true;
}

TEST_CASE("convex_hull_2d: points, segments and polygons worked by hand") {
  hull_is<Row>(Points{{3, 4}}, 0, {0});
  hull_is<Row>(Points{{0, 1}, {-0.0, 1}, {0, 1}}, 0, {0});
  hull_is<Row>(Points{{5, 5}, {1, 1}}, 1, {0, 1});
  hull_is<Row>(Points{{0, 0}, {3, 0}, {0, 3}}, 2, {0, 1, 2});
  hull_is<Row>(Points{{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 2}, {2, 2}, {1, 1}}, 2, {0, 1, 2, 3, 4});
  hull_is<Row>(Points{{4, 0}, {0, 4}, {-4, 0}, {0, -4}, {0, 4}, {0, -4}}, 2, {0, 1, 2, 3});
}

TEST_CASE("convex_hull_2d: points inside edges are no corners; the formula may take them for some") {
  hull_is<Row>(Points{{0, 0}, {1, 1}, {2, 2}}, 1, {0, 2}, false);
  hull_is<Row>(Points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 4}, {0, 2}}, 2, {0, 1, 2, 3});
  hull_is<Row>(Points{{2, 0}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}, 2, {1, 2, 3, 4}, false);
  hull_is<Row>(Points{{2, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}}, 2, {1, 2, 3, 4}, false);  // it begins inside an edge
}

TEST_CASE("convex_hull_2d: rounding, huge and subnormal coordinates") {
  const Points quad{{0, 0}, {4, 1}, {5, 5}, {1, 4}, {2, 2}};
  hull_is<Row>(scaled_points(quad, 0x1p1000), 2, {0, 1, 2, 3}, false);  // products overflow
  hull_is<Row>(scaled_points(quad, tiny), 2, {0, 1, 2, 3}, false);      // and underflow
  hull_is<Row>(Points{{-huge, -huge}, {huge, huge}, {0, 0}, {tiny, 0}}, 2, {0, 1, 3}, false);
  // From (1, 0) two points lie ahead, by angles of about 1e-9: both cosines are 1, and the nearer is a corner too.
  hull_is<Row>(Points{{0, 0}, {1, 0}, {3, 0x1p-28}, {2, 0x1p-30}, {1, 3}}, 2, {0, 1, 2, 3, 4}, false);
  // 0.1 + 0.2 is above 0.3 as a double.
  hull_is<Row>(Points{{0, 0}, {0.1 + 0.2, 0.3}, {1, 1}, {1, 0}}, 2, {0, 2, 3});
  hull_is<Row>(Points{{0, 0}, {0.3, 0.1 + 0.2}, {1, 1}, {1, 0}}, 2, {0, 1, 2, 3}, false);
}

TEST_CASE("convex_hull_2d: margins by hand") {
  const auto margin = [](const Points& points) { return catalogue::ask_oracle<Row>(std::tuple(points)).margin; };
  CHECK(!margin({{3, 4}}));
  CHECK(*margin({{3, 4}, {3, 4}}) == 0);
  CHECK(*margin({{0, 0}, {3, 4}}) == 25);
  CHECK(*margin({{0, 0}, {1, 1}, {2, 2}}) == 0);
  CHECK(*margin({{0, 0}, {3, 0}, {0, 3}}) == 9);
  CHECK(*margin({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}}) == 4);  // the edge below and the point over it
  CHECK(*margin({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {4, 4}}) == 0);
}

TEST_CASE("convex_hull_2d: the checkers say the same of altered answers") {
  hull_checkers_agree<Row>([](catalogue::DrawStream& c, ConvexHull2& hull, Index count) {
    if (hull.point) hull.point = static_cast<Index>(c.below(count));
    if (hull.segment && c.below(2) == 1) hull.segment->i = static_cast<Index>(c.below(count));
    if (!hull.polygon) return;
    std::vector<Index>& ring = *hull.polygon;
    switch (c.below(5)) {
      case 0: ring[c.below(ring.size())] = static_cast<Index>(c.below(count)); return;
      case 1: std::rotate(ring.begin(), ring.begin() + 1, ring.end()); return;
      case 2: ring.push_back(static_cast<Index>(c.below(count))); return;
      case 3: std::reverse(ring.begin(), ring.end()); return;
      default:
        if (ring.size() > 3) ring.pop_back();
    }
  });
}

TEST_CASE("convex_hull_2d: the formula in double is right beyond the margins of its contract") {
  int beyond = 0;
  never(
      catalogue::operation_of_row<Row>(), "the forward error bound holds",
      [&](const Question& question) -> std::string {
        const auto asked = typed<Row>(question);
        if (std::get<0>(asked).empty()) return "";
        if (!beyond_margins(std::get<0>(asked), catalogue::ask_oracle<Row>(asked).answer)) return "";
        ++beyond;
        return Row::defect(asked, catalogue::ask_reference<Row>(asked));
      },
      4);
  CHECK(beyond > 100);
}

TEST_CASE("convex_hull_2d: a ring that turns left at every corner and goes round twice is no hull") {
  const std::vector<Point2d> pentagon{{0, 3}, {-3, 1}, {-2, -3}, {2, -3}, {3, 1}};
  CHECK(Row::defect({pentagon}, {2, {}, {}, std::vector<Index>{0, 1, 2, 3, 4}}) == "");
  CHECK(Row::defect({pentagon}, {2, {}, {}, std::vector<Index>{0, 2, 4, 1, 3}}).starts_with("outside is point"));
  CHECK(Row::defect({pentagon}, {2, {}, {}, std::vector<Index>{0, 1, 2, 3}}) == "outside is point 4");
}

TEST_CASE("convex_hull_2d: rings drawn by others") {
  const std::vector<Polygon2d> rings = polygons_from_elsewhere();
  if (rings.empty()) WARN("skipped: no polygons below TOUCHSTONE_DATA or ../shared/data");
  for (const Polygon2d& ring : rings) {
    INFO("ring of " << ring.size() << " vertices");
    CHECK(Row::defect({ring.vertices}, robust::convex_hull_2d(ring.vertices)) == "");
  }
}

// Seconds; on the circle, a nanosecond for each pair of points would be a quarter of an hour, and the limit in ctest is
// a third of that (cmake/proptests.cmake).
TEST_CASE("convex_hull_2d: very many points on a circle, in a square and on a line") {
  std::mt19937_64 next(1);
  const auto number = [&next] { return static_cast<double>(next() >> 11) * 0x1p-53; };
  for (int shape = 0; shape < 3; ++shape) {
    Points points;
    for (int i = 0; i < 1'000'000; ++i) {
      const double x = number(), y = number(), angle = 7 * x;
      points.push_back(shape == 0   ? Point2d{std::cos(angle), std::sin(angle)}
                       : shape == 1 ? Point2d{x, y}
                                    : Point2d{x, x});
    }
    CAPTURE(shape);
    CHECK(robust::convex_hull_2d(points).dimension == (shape == 2 ? 1 : 2));
  }
}

}  // namespace touchstone::proptests::convex_hull_2d_tests
