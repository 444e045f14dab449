// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/convex_hull.h"

#include "proptests/clouds.h"
#include "proptests/hull_laws.h"
#include "proptests/space_laws.h"
#include "robust/hulls/solid.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/volumes/convex_hull_2d.h"

namespace touchstone::proptests::convex_hull_tests {
namespace {

using Row = rows::convex_hull;
using Points = Row::Points;

Points cube(int size) {
  Points points;
  for (int i = 0; i < size * size * size; ++i)
    points.push_back({1.0 * (i % size), 1.0 * (i / size % size), 1.0 * (i / size / size)});
  return points;
}

/// The faces of points that are not in one plane, found with far points looked for, or without.
std::vector<Face> faces_looking_far_from(std::size_t count, const Points& points) {
  const robust::kernel::ControlWord ieee;
  Stage latest = Stage::filter;
  return robust::hulls::solid_of(points, *robust::hulls::frame_of(points), latest, count).faces;
}

/// Whether rounding can decide nothing wrong in the slide's formula, by the bounds of reference/volumes/convex_hull.h.
bool beyond_margins(const Points& points) {
  if (points.size() < 4 || points.size() > 6) return false;
  using Vector = Vector3<Rational>;
  const auto between = [&](std::size_t a, std::size_t b) {
    const Point3d &p = points[a], &q = points[b];
    return Vector{Rational(exact(q.x) - exact(p.x)), Rational(exact(q.y) - exact(p.y)),
                  Rational(exact(q.z) - exact(p.z))};
  };
  const auto moderate = [](const Rational& x) {
    return sgn(x) == 0 || (abs(x) >= power_of_two(-100) && abs(x) <= power_of_two(100));
  };
  const std::size_t n = points.size();
  std::size_t highest = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (points[i].y > points[highest].y) highest = i;
  // The squared sines, and the values of step 2.
  Rational least_sine(1);
  std::vector<Rational> rises;
  for (std::size_t a = 0; a < n; ++a) {
    if (a != highest && points[a].y == points[highest].y) return false;
    for (std::size_t b = 0; b < n; ++b) {
      const Vector v = between(a, b);
      if (!moderate(v.x) || !moderate(v.y) || !moderate(v.z)) return false;
      if (a == highest && b != a) {
        if (sgn(dot(v, v)) == 0) return false;
        rises.push_back((v.x * v.x + v.z * v.z) / dot(v, v));
      }
      for (std::size_t c = 0; c < b; ++c) {
        if (a == b || a == c) continue;
        const Vector w = between(a, c), normal = cross(v, w);
        if (sgn(dot(normal, normal)) == 0) return false;
        least_sine = std::min(least_sine, Rational(dot(normal, normal) / (dot(v, v) * dot(w, w))));
      }
    }
  }
  if (least_sine < power_of_two(-40)) return false;
  // |x - y| > 80 u / s
  const auto apart = [&](const Rational& x, const Rational& y) {
    return (x - y) * (x - y) * least_sine > 6400 * unit() * unit();
  };
  const auto all_apart = [&](const std::vector<Rational>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (!apart(values[i], values[k])) return false;
    return true;
  };
  if (!all_apart(rises)) return false;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      if (a == b) continue;
      const Vector e = between(a, b);
      for (std::size_t c = 0; c <= n; ++c) {  // n: the plane of step 3
        if (c == a || c == b || (c == n && a != highest)) continue;
        const Vector plane = c == n ? cross(e, Vector{e.z, 0, Rational(-e.x)}) : cross(e, between(a, c));
        if (sgn(dot(plane, plane)) == 0) return false;
        std::vector<Rational> values;
        for (std::size_t i = 0; i < n; ++i) {
          if (i == a || i == b) continue;
          const Vector other = cross(Vector{Rational(-e.x), Rational(-e.y), Rational(-e.z)}, between(b, i));
          const Vector turned = c == n ? cross(e, between(a, i)) : other;
          const Rational product = dot(plane, turned);
          values.push_back(product * abs(product) / (dot(plane, plane) * dot(turned, turned)));
        }
        if (!all_apart(values)) return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE("convex_hull: the hull does not hang on the order of the points, and every corner is needed") {
  hulls_are_hulls<Row>();
}

TEST_CASE("convex_hull: symmetries and powers of two carry hulls to hulls") {
  law<Row>("images", [](const auto& ask, const auto& asked) {
    return std::all_of(axis_maps.begin(), axis_maps.end(), [&](const AxisMap& map) {
      const auto image = map(asked);
      return same_points(corners_of(std::get<0>(image), ask(asked)), corners_of(std::get<0>(image), ask(image)));
    });
  });
  robust_law<Row>("scales", scales<Row>);
}

ROBUST_LAW("convex_hull: robust gives the faces that the contract of robust names: those of the oracle, in its order") {
  const ConvexHull hull = ask(asked);
  return hull.dimension != 3 || equal(hull, catalogue::ask_oracle<Row>(asked).answer);
}

ROBUST_LAW("convex_hull: looking for far points first changes nothing", points) {
  const ConvexHull hull = ask(asked);
  return !hull.faces || (faces_looking_far_from(5, points) == *hull.faces &&
                         faces_looking_far_from(points.size() + 1, points) == *hull.faces);
}

ROBUST_LAW("convex_hull: points in the plane z = 0 have the hull that they have in the plane") {
  Points flat = std::get<0>(asked);
  std::vector<Point2d> projected;
  for (Point3d& p : flat) p.z = 0, projected.push_back({p.x, p.y});
  const ConvexHull hull = ask(std::tuple(flat));
  const ConvexHull2 in_plane = robust::convex_hull_2d(projected);
  return hull.dimension == in_plane.dimension && hull.polygon == in_plane.polygon && hull.point == in_plane.point &&
         hull.segment == in_plane.segment;
}

TEST_CASE("convex_hull: points, segments, polygons and solids worked by hand") {
  hull_is<Row>(Points{{3, 4, 5}}, 0, {0});
  hull_is<Row>(Points{{0, 1, 0}, {-0.0, 1, -0.0}}, 0, {0});
  hull_is<Row>(Points{{5, 5, 5}, {1, 1, 0}}, 1, {0, 1});
  hull_is<Row>(Points{{0, 0, 0}, {3, 0, 1}, {0, 3, 2}}, 2, {0, 1, 2});
  hull_is<Row>(Points{{0, 0, 0}, {4, 0, 1}, {0, 4, 0}, {1, 2, 5}}, 3, {0, 1, 2, 3});
  hull_is<Row>(Points{{0, 0, 0}, {4, 0, 1}, {0, 4, 0}, {1, 2, 5}, {1, 1, 1}}, 3, {0, 1, 2, 3});  // one inside
  hull_is<Row>(Points{{9, 1, 0}, {-9, 2, 0}, {1, 9, 1}, {0, -9, 2}, {0, 1, 9}, {2, 0, -9}}, 3, {0, 1, 2, 3, 4, 5});
}

TEST_CASE("convex_hull: flat faces, and points inside faces and edges; the formula may lose its way there") {
  const Points grid = cube(3);
  hull_is<Row>(grid, 3, {0, 2, 6, 8, 18, 20, 24, 26}, false);
  CHECK(robust::convex_hull(cube(2)).faces == std::vector<Face>{{0, 1, 5},
                                                                {0, 2, 3},
                                                                {0, 3, 1},
                                                                {0, 4, 6},
                                                                {0, 5, 4},
                                                                {0, 6, 2},
                                                                {1, 3, 7},
                                                                {1, 7, 5},
                                                                {2, 6, 7},
                                                                {2, 7, 3},
                                                                {4, 5, 7},
                                                                {4, 7, 6}});
  hull_is<Row>(Points{{1, 1, 2}, {2, 0, 0}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, 3, {2, 3, 4, 5}, false);
  hull_is<Row>(Points{{1, 1, 1}, {0, 0, 0}, {3, 3, 3}, {2, 2, 2}}, 1, {1, 2}, false);
  hull_is<Row>(Points{{0, 0, 0}, {4, 0, 4}, {4, 4, 8}, {0, 4, 4}, {2, 2, 4}}, 2, {0, 1, 2, 3}, false);
}

TEST_CASE("convex_hull: rounding, huge and subnormal coordinates") {
  const Points tetrahedron{{0, 0, 0}, {4, 0, 1}, {0, 4, 0}, {1, 2, 5}, {1, 1, 1}};
  hull_is<Row>(scaled_points(tetrahedron, 0x1p1000), 3, {0, 1, 2, 3}, false);
  hull_is<Row>(scaled_points(tetrahedron, tiny), 3, {0, 1, 2, 3}, false);
  hull_is<Row>(Points{{-huge, -huge, 0}, {huge, huge, 0}, {0, 0, 0}, {tiny, 0, 0}, {0, 0, tiny}}, 3, {0, 1, 3, 4},
               false);
  // 0.1 + 0.2 is above 0.3: the last point is out of the plane x + y + z = 0.6 by an ulp, or in it as far as rounding
  //    sees.
  hull_is<Row>(Points{{0.6, 0, 0}, {0, 0.6, 0}, {0, 0, 0.6}, {0, 0, 0}, {0.3, 0.1, 0.2}}, 3, {0, 1, 2, 3, 4}, false);
}

TEST_CASE("convex_hull: margins by hand") {
  const auto margin = [](const Points& points) { return catalogue::ask_oracle<Row>(std::tuple(points)).margin; };
  CHECK(!margin({{3, 4, 5}}));
  CHECK(*margin({{0, 0, 0}, {3, -4, 0}}) == 64);
  CHECK(*margin({{0, 0, 0}, {3, 0, 0}, {0, 3, 1}}) == 27);  // the cross product is (0, -3, 9)
  CHECK(*margin({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}) == 0);
  CHECK(*margin({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}) == 0);
  CHECK(*margin({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}) == 27);
  CHECK(*margin({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}}) ==
        16);  // each face and the point: 16, once 16
  CHECK(*margin(cube(2)) == 0);
}

TEST_CASE("convex_hull: the checkers say the same of altered answers") {
  hull_checkers_agree<Row>([](catalogue::DrawStream& c, ConvexHull& hull, Index count) {
    if (hull.point) hull.point = static_cast<Index>(c.below(count));
    if (hull.segment && c.below(2) == 1) hull.segment->i = static_cast<Index>(c.below(count));
    if (hull.polygon && c.below(2) == 1) std::reverse(hull.polygon->begin(), hull.polygon->end());
    else if (hull.polygon) hull.polygon->push_back(static_cast<Index>(c.below(count)));
    if (!hull.faces || hull.faces->empty()) return;
    std::vector<Face>& faces = *hull.faces;
    const std::size_t which = c.below(faces.size());
    Face& face = faces[which];
    switch (c.below(6)) {
      case 0: face.a = static_cast<Index>(c.below(count)); return;
      case 1: std::swap(face.b, face.c); return;
      case 2: faces.pop_back(); return;
      case 3: faces.push_back(face); return;
      case 4: face = {face.b, face.c, face.a}; return;
      default:
        // Another diagonal: right where both triangles lie in one plane.
        for (Face& other : faces) {
          if (other.a != face.a || other.b != face.c) continue;
          const Index d = other.c;
          other = {d, face.b, face.c}, face = {d, face.a, face.b};
          return;
        }
    }
  });
}

TEST_CASE("convex_hull: the formula in double is right beyond the margins of its contract") {
  int beyond = 0;
  never(
      catalogue::operation_of_row<Row>(), "the forward error bound holds",
      [&](const Question& question) -> std::string {
        const auto asked = typed<Row>(question);
        if (!beyond_margins(std::get<0>(asked))) return "";
        ++beyond;
        return Row::defect(asked, catalogue::ask_reference<Row>(asked));
      },
      48);
  CHECK(beyond > 100);
}

TEST_CASE("convex_hull: thousands of points, by the definition") {
  for (int shape = 0; shape < 7; ++shape) {
    for (const std::size_t count : {1000u, 3000u}) {
      for (const int bits : {14, 26}) {
        const Points points = cloud(shape, count, bits);
        const ConvexHull hull = robust::convex_hull(points);
        CAPTURE(shape, count, bits);
        REQUIRE(hull.faces);
        CHECK(is_hull(points, *hull.faces));
        CHECK(faces_looking_far_from(count + 1, points) == *hull.faces);
        // The same coordinates with all their bits: no lattice holds them.
        const Points tenths = scaled_points(points, 0.1);
        const ConvexHull rounded = robust::convex_hull(tenths);
        CHECK(rounded.faces == faces_looking_far_from(count + 1, tenths));
        if (count == 1000 && bits == 14) CHECK(Row::defect({tenths}, rounded) == "");
      }
    }
  }
}

TEST_CASE("convex_hull: a polygon that turns left at every corner and goes round twice is no hull") {
  const Points pentagon{{0, 3, 1}, {-3, 1, 1}, {-2, -3, 1}, {2, -3, 1}, {3, 1, 1}};
  CHECK(Row::defect({pentagon}, {2, {}, {}, std::vector<Index>{0, 1, 2, 3, 4}, {}}) == "");
  CHECK(Row::defect({pentagon}, {2, {}, {}, std::vector<Index>{0, 2, 4, 1, 3}, {}}).starts_with("outside is point"));
  CHECK(Row::defect({pentagon}, {2, {}, {}, std::vector<Index>{0, 1, 2, 3}, {}}) == "outside is point 4");
}

TEST_CASE("convex_hull: clouds that other programs stumbled over") {
  const auto clouds = clouds_from_elsewhere();
  if (clouds.empty()) WARN("skipped: no clouds below TOUCHSTONE_DATA or ../shared/data");
  for (const auto& [name, points] : clouds) {
    INFO(name);
    CHECK(Row::defect({points}, robust::convex_hull(points)) == "");
  }
}

TEST_CASE("convex_hull: threads change nothing") {
  std::mt19937_64 next(2);
  const auto number = [&next] { return static_cast<double>(next() >> 11) * 0x1p-52 - 1; };
  for (int shape = 0; shape < 5; ++shape) {
    Points points;
    while (points.size() < 60'000) {
      const double x = number(), y = number(), z = number(), root = std::sqrt(x * x + y * y + z * z);
      if (root > 1 || root == 0) continue;
      const Point3d p{x / root, y / root, z / root};
      if (shape == 0) points.push_back({x, y, z});
      else if (shape == 1) points.push_back(p);
      else if (shape == 2) points.push_back({std::floor(99 * p.x), std::floor(99 * p.y), std::floor(99 * p.z)});
      else if (shape == 3) points.push_back({p.x, p.y, std::floor(2 * p.z)});  // four planes
      else points.push_back({p.x, 1e-3 * p.y, points.size() < 30'000 ? p.z : 1e6 + p.z});  // two thin ones, far apart
    }
    const ConvexHull alone = robust::convex_hull(points);
    for (const std::size_t threads : {2U, 3U, 8U}) {
      CAPTURE(shape, threads);
      CHECK(robust::convex_hull(points, threads).faces == alone.faces);
    }
  }
}

// Seconds; where all points are on the sphere, two nanoseconds for each pair of them would be twelve minutes, and the
// limit in ctest is less than half of that (cmake/proptests.cmake).
TEST_CASE("convex_hull: very many points in a ball, on a sphere, on a grid and in a plane") {
  std::mt19937_64 next(1);
  const auto number = [&next] { return static_cast<double>(next() >> 11) * 0x1p-52 - 1; };
  for (int shape = 0; shape < 4; ++shape) {
    Points points;
    while (points.size() < 600'000) {
      const double x = number(), y = number(), z = number(), square = x * x + y * y + z * z, root = std::sqrt(square);
      if (square > 1 || root == 0) continue;
      if (shape == 0) points.push_back({x, y, z});
      else if (shape == 1) points.push_back({x / root, y / root, z / root});
      else if (shape == 2) points.push_back({std::floor(9 * x), std::floor(9 * y), std::floor(9 * z)});
      else points.push_back({std::floor(99 * x), std::floor(99 * y), std::floor(99 * x) + std::floor(99 * y)});
    }
    CAPTURE(shape);
    const ConvexHull hull = robust::convex_hull(points);
    CHECK(hull.dimension == (shape == 3 ? 2 : 3));
    CHECK(robust::convex_hull(points, 0).faces == hull.faces);
  }
}

}  // namespace touchstone::proptests::convex_hull_tests
