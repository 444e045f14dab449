// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/aabb_of_points.h"

#include "proptests/space_laws.h"

namespace touchstone::proptests::aabb_of_points_tests {
namespace {

using Row = rows::aabb_of_points;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;
using Box2 = Aabb2<Rational>;
using Box3 = Aabb3<Rational>;

/// Holds of points, in the plane or in space: `holds(box_of, points)`, box_of: points -> their box.
template <class Holds>
auto of_points(const Holds& holds) {
  return [holds](const auto& ask, const auto& asked) {
    return std::visit(
        [&](const auto& arguments) {
          const auto box_of = [&](const auto& points) { return ask(Row::Question{std::tuple(points)}); };
          return holds(box_of, std::get<0>(arguments));
        },
        asked);
  };
}

/// min.x, min.y ... max.x, max.y ...
template <class Answer>
auto ends(const Answer& box) {
  std::vector<catalogue::number_of_t<Answer>> numbers;
  catalogue::for_each_number(box, [&](const auto& number) { numbers.push_back(number); });
  return numbers;
}

template <class Points>
Points without(Points points, std::size_t i) {
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
  return points;
}

template <class Points, class Answer>
void worked(const Points& points, const Answer& box) {
  example<Row>(std::tuple(points), box);
}

}  // namespace

TEST_CASE("aabb_of_points: the order of the points, and how often each is there, do not matter") {
  law<Row>("permuted", of_points([](const auto& box_of, const auto& points) {
             auto other = points;
             std::reverse(other.begin(), other.end());
             other.insert(other.end(), points.begin(), points.end());
             std::rotate(other.begin(), other.begin() + 1, other.end());
             return ends(box_of(other)) == ends(box_of(points));
           }));
}

TEST_CASE("aabb_of_points: without one of the points the box is no larger, and the hull of it and that point") {
  law<Row>("one less", of_points([](const auto& box_of, const auto& points) {
             if (points.size() < 2) return true;
             const auto all = ends(box_of(points));
             const std::size_t axes = all.size() / 2;
             for (const std::size_t gone : {std::size_t{0}, points.size() / 2, points.size() - 1}) {
               const auto rest = ends(box_of(without(points, gone))),
                          point = ends(box_of(std::decay_t<decltype(points)>{points[gone]}));
               for (std::size_t k = 0; k < axes; ++k) {
                 if (all[k] != std::min(rest[k], point[k])) return false;
                 if (all[axes + k] != std::max(rest[axes + k], point[axes + k])) return false;
               }
             }
             return true;
           }));
}

TEST_CASE("aabb_of_points: robust returns 0 as 0.0 alone") {
  robust_law<Row>("one zero", of_points([](const auto& box_of, const auto& points) {
                    const auto numbers = ends(box_of(points));
                    return std::none_of(numbers.begin(), numbers.end(), [](double x) {
                      return catalogue::moved_by_ulps(x, 0) == 0 && std::signbit(x);
                    });
                  }));
}

TEST_CASE("aabb_of_points: the box of points in the plane is that of space without z") {
  law<Row>("raised", of_points([](const auto& box_of, const auto& points) {
             if constexpr (std::is_same_v<decltype(points), const InPlane&>) {
               InSpace raised;
               for (const Point2d& p : points) raised.push_back({p.x, p.y, 7});
               auto expected = ends(box_of(points));
               expected.insert(expected.begin() + 2, 7), expected.push_back(7);
               return ends(box_of(raised)) == expected;
             }
             return true;
           }));
}

TEST_CASE("aabb_of_points: p. 28-30's boxes worked by hand") {
  worked(InPlane{{1, 5}, {4, 2}, {3, 3}}, Box2{{1, 2}, {4, 5}});
  worked(InPlane{{4, 2}, {3, 3}, {1, 5}}, Box2{{1, 2}, {4, 5}});
  worked(InPlane{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}, Box2{{-1, -1}, {1, 1}});
  worked(InSpace{{1, 5, 9}, {4, 2, -9}, {3, 3, 0}}, Box3{{1, 2, -9}, {4, 5, 9}});
  worked(InPlane{{7, -2}}, Box2{{7, -2}, {7, -2}});                       // a point
  worked(InSpace{{7, -2, 3}, {7, -2, 3}}, Box3{{7, -2, 3}, {7, -2, 3}});  // twice
  worked(InPlane{{0, 3}, {5, 3}, {2, 3}}, Box2{{0, 3}, {5, 3}});          // flat
  worked(InSpace{{1, 0, 2}, {3, 0, 1}}, Box3{{1, 0, 1}, {3, 0, 2}});      // flat
  worked(InPlane{{0.1, 0.5}, {0.25, 0.75}}, Box2{{exact(0.1), Rational(1, 2)}, {Rational(1, 4), Rational(3, 4)}});
}

CONTRACT("aabb_of_points: the formula in double is right everywhere, as in exact arithmetic") {
  const auto right = ends(truth.answer);
  const auto found = ends(answer);
  for (std::size_t i = 0; i < right.size(); ++i)
    if (exact(found[i]) != right[i]) return false;
  return found.size() == right.size();
}

TEST_CASE("aabb_of_points: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::aabb_of_points_tests
