// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/closest_point_on_aabb.h"

#include "proptests/forward_error.h"

namespace touchstone::proptests::closest_point_on_aabb_tests {
namespace {

using Row = rows::closest_point_on_aabb;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;

using proptests::exact;
Rational exact(const Rational& value) { return value; }

template <class Point>
std::vector<Rational> coordinates(const Point& p) {
  std::vector<Rational> all{exact(p.x), exact(p.y)};
  if constexpr (requires { p.z; }) all.push_back(exact(p.z));
  return all;
}
template <class Real>
std::vector<Rational> coordinates(const std::variant<Point2<Real>, Point3<Real>>& answer) {
  return std::visit([](const auto& p) { return coordinates(p); }, answer);
}

/// Holds of a point and a box: `holds(ask, point, aabb)`. ask(point, aabb): the coordinates of the answer.
template <class Holds>
auto of_point_and_box(const Holds& holds) {
  return [holds](const auto& ask, const auto& asked) {
    const auto answered = [&](const auto& p, const auto& box) { return coordinates(ask(std::tuple(p, box))); };
    return catalogue::applied([&](const auto& p, const auto& box) { return holds(answered, p, box); }, asked);
  };
}

Aabb3d between(const Aabb2d& b, double z0, double z1) { return {{b.min.x, b.min.y, z0}, {b.max.x, b.max.y, z1}}; }

/// (x, y) or (x, y, z).
Row::Question asked(const std::vector<double>& p, const std::vector<double>& min, const std::vector<double>& max) {
  if (p.size() == 2) return InPlane{{p[0], p[1]}, {{min[0], min[1]}, {max[0], max[1]}}};
  return InSpace{{p[0], p[1], p[2]}, {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}}};
}

void worked(const Row::Question& question, const std::vector<Rational>& x) {
  if (x.size() == 2) example<Row>(question, Point2<Rational>{x[0], x[1]});
  else example<Row>(question, Point3<Rational>{x[0], x[1], x[2]});
}

}  // namespace

TEST_CASE("closest_point_on_aabb: the nearest point is in the box, and the way to it turns away from every corner") {
  law<Row>("the way ends at a right angle or an obtuse one",
           of_point_and_box([](const auto& ask, const auto& p, const auto& box) {
             const std::vector<Rational> x = ask(p, box), from = coordinates(p), min = coordinates(box.min),
                                         max = coordinates(box.max);
             for (std::size_t k = 0; k < x.size(); ++k) {
               if (x[k] < min[k] || x[k] > max[k]) return false;
               // (p - x) . (y - x) <= 0 for every y in the box: axis by axis, of both ends.
               const Rational displacement(from[k] - x[k]);
               if (displacement * (min[k] - x[k]) > 0 || displacement * (max[k] - x[k]) > 0) return false;
             }
             return true;
           }));
}

TEST_CASE("closest_point_on_aabb: a point of the box is its own, min and max too") {
  law<Row>("projection", of_point_and_box([](const auto& ask, const auto&, const auto& box) {
             return ask(box.min, box) == coordinates(box.min) && ask(box.max, box) == coordinates(box.max);
           }));
  robust_law<Row>("asked again, bit for bit", [](const auto& ask, const auto& question) {
    return catalogue::applied(
        [&](const auto& p, const auto& box) {
          const auto once = ask(std::tuple(p, box));
          const auto twice = ask(std::tuple(std::get<std::remove_cvref_t<decltype(p)>>(once), box));
          std::vector<std::uint64_t> one, two;
          append_bits(once, one), append_bits(twice, two);
          return one == two;
        },
        question);
  });
}

TEST_CASE("closest_point_on_aabb: of the box that is one point, that point") {
  law<Row>("a point as a box", of_point_and_box([](const auto& ask, const auto& p, const auto& box) {
             using Box = std::remove_cvref_t<decltype(box)>;
             return ask(box.min, Box{p, p}) == coordinates(p) && ask(p, Box{box.max, box.max}) == coordinates(box.max);
           }));
}

TEST_CASE("closest_point_on_aabb: in the plane it is what it is in space at any height") {
  law<Row>("in space", of_point_and_box([](const auto& ask, const auto& p, const auto& box) {
             if constexpr (requires { p.z; }) return true;
             else {
               std::vector<Rational> x = ask(p, box);
               x.emplace_back(exact(huge));
               return ask(Point3d{p.x, p.y, huge}, between(box, -huge, huge)) == x &&
                      ask(Point3d{p.x, p.y, greatest}, between(box, tiny, huge)) == x;
             }
           }));
}

TEST_CASE("closest_point_on_aabb: p. 48-50's cases worked by hand, in the plane") {
  worked(asked({1, 2}, {0, 0}, {4, 4}), {1, 2});   // inside
  worked(asked({-3, 2}, {0, 0}, {4, 4}), {0, 2});  // beyond a side
  worked(asked({1, 9}, {0, 0}, {4, 4}), {1, 4});   // beyond another
  worked(asked({7, -8}, {0, 0}, {4, 4}), {4, 0});  // beyond a corner
  worked(asked({4, 1}, {0, 0}, {4, 4}), {4, 1});   // on a side
  worked(asked({4, 4}, {0, 0}, {4, 4}), {4, 4});   // a corner itself
  worked(asked({0.1, 5}, {0.1, 0}, {0.3, 0.2}), {exact(0.1), exact(0.2)});
}

TEST_CASE("closest_point_on_aabb: p. 48-50's cases worked by hand, in space") {
  worked(asked({1, 2, 3}, {0, 0, 0}, {4, 4, 4}), {1, 2, 3});
  worked(asked({1, 2, 9}, {0, 0, 0}, {4, 4, 4}), {1, 2, 4});     // beyond a face
  worked(asked({1, -2, 9}, {0, 0, 0}, {4, 4, 4}), {1, 0, 4});    // beyond an edge
  worked(asked({-1, -2, -9}, {0, 0, 0}, {4, 4, 4}), {0, 0, 0});  // beyond a corner
  worked(asked({5, 6, 7}, {0, 0, 0}, {4, 4, 4}), {4, 4, 4});
}

TEST_CASE("closest_point_on_aabb: flat boxes") {
  worked(asked({1, 2, 3}, {0, 0, 2}, {4, 4, 2}), {1, 2, 2});  // a rectangle, from in front
  worked(asked({1, 2, 2}, {0, 0, 2}, {4, 4, 2}), {1, 2, 2});  // in it
  worked(asked({1, 2, 3}, {0, 5, 2}, {4, 5, 2}), {1, 5, 2});  // a segment
  worked(asked({1, 2, 3}, {5, 5, 5}, {5, 5, 5}), {5, 5, 5});  // a point
  worked(asked({1, 2}, {3, 0}, {3, 4}), {3, 2});
}

CONTRACT("closest_point_on_aabb: the formula in double is right everywhere, as in exact arithmetic") {
  return coordinates(answer) == coordinates(truth.answer);
}

TEST_CASE("closest_point_on_aabb: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::closest_point_on_aabb_tests
