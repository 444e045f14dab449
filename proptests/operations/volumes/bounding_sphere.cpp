// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/bounding_sphere.h"

#include "proptests/forward_error.h"

namespace touchstone::proptests::bounding_sphere_tests {
namespace {

using Row = rows::bounding_sphere;
using Points = std::vector<Point3d>;
using oracle::Surd;

constexpr auto box = SphereMethod::box, centroid = SphereMethod::centroid, ritter = SphereMethod::ritter,
               smallest = SphereMethod::smallest;
Rational squared_distance(const Point3d& p, const Point3d& q) {
  const auto square = [](double from, double to) {
    const Rational x(exact(to) - exact(from));
    return Rational(x * x);
  };
  return square(p.x, q.x) + square(p.y, q.y) + square(p.z, q.z);
}
bool holds(const Sphere3d& ball, const Point3d& p) {
  if (std::isinf(ball.radius)) return true;
  return squared_distance(ball.center, p) <= exact(ball.radius) * exact(ball.radius);
}
bool holds_all(const Sphere3d& ball, const Points& points) {
  return std::all_of(points.begin(), points.end(), [&](const Point3d& p) { return holds(ball, p); });
}

bool same(const Sphere3d& a, const Sphere3d& b) { return a.center == b.center && a.radius == b.radius; }
bool same(const Sphere3<Surd>& a, const Sphere3<Surd>& b) { return a.center == b.center && a.radius == b.radius; }

Sphere3<Surd> ball(const Rational& x, const Rational& y, const Rational& z, const Surd& radius) {
  return {{Surd(x), Surd(y), Surd(z)}, radius};
}
Surd root(const Rational& square) { return sqrt(Surd(square)); }

std::string defect(const Points& points, SphereMethod method, const Sphere3d& ball) {
  return Row::defect({points, method}, ball);
}

/// The oracle answers exactly this; robust is right by the checker, and so is the reference, unless it gets another
/// verdict.
void worked(const Points& points, SphereMethod method, const Sphere3<Surd>& expected,
            const std::string& by_reference = "agree") {
  const Operation& operation = catalogue::operation_of_row<Row>();
  const auto examination = examined<Row>({points, method});
  CHECK(catalogue::one_line(examination->truth()) ==
        catalogue::one_line(operation.answer_json(catalogue::packed_as<catalogue::TrueNumber>(expected))));
  CHECK(name_of(examination->judge_robust().verdict) == std::string("agree"));
  CHECK(name_of(examination->judge_reference().verdict) == by_reference);
}

const Points quadrilateral{{0, 0, 0}, {8, 0, 0}, {4, 3, 0}, {4, 1, 0}};

}  // namespace

ROBUST_LAW("bounding_sphere: every point is in the ball of robust, and with the double below its radius one is not",
           points) {
  const Sphere3d ball = ask(asked);
  if (!holds_all(ball, points)) return false;
  if (ball.radius == 0) return true;
  const double less = std::nextafter(ball.radius, 0);
  return !holds_all({ball.center, less}, points);
}

TEST_CASE("bounding_sphere: but for ritter the center of robust is the exact one, correctly rounded") {
  robust_law<Row>(
      "center",
      [](const auto& ask, const auto& asked) {
        if (std::get<1>(asked) == ritter) return true;
        const auto exactly = catalogue::ask_oracle<Row>(asked).answer.center;
        const Sphere3d ball = ask(asked);
        return ball.center ==
               Point3d{catalogue::nearest(exactly.x), catalogue::nearest(exactly.y), catalogue::nearest(exactly.z)};
      },
      3);
}

LAW("bounding_sphere: but to ritter the order of the points does not matter, and but to centroid not how many") {
  auto [points, method] = asked;
  if (method == ritter) return true;
  const auto ball = ask(asked);
  std::reverse(points.begin(), points.end());
  if (!same(ask(Row::Question{points, method}), ball)) return false;
  points.push_back(points[0]);
  return method == centroid || same(ask(Row::Question{points, method}), ball);
}

TEST_CASE("bounding_sphere: of the exact balls the smallest is the smallest, and ritter's at most 3/2 of it") {
  never(
      catalogue::operation_of_row<Row>(), "smallest",
      [](const Question& question) -> std::string {
        const auto [points, method] = typed<Row>(question);
        const auto radius = [&points = points](SphereMethod by) {
          return catalogue::ask_oracle<Row>(Row::Question{points, by}).answer.radius;
        };
        try {
          const Surd least = radius(smallest), grown = radius(ritter);
          return least <= radius(box) && least <= radius(centroid) && least <= grown &&
                         grown <= Surd(Rational(3, 2)) * least
                     ? ""
                     : "a ball is smaller than the smallest, or ritter's is too large";
        } catch (const InvalidInput&) {
          return "";
        }
      },
      1);
}

ROBUST_LAW("bounding_sphere: a method that is left out is smallest", points) {
  return same(ask(Row::Question{points, std::nullopt}), ask(Row::Question{points, smallest}));
}

TEST_CASE("bounding_sphere: one point and equal points have that point and radius 0") {
  for (const SphereMethod method : {box, centroid, ritter, smallest}) {
    worked({{1, 2, 3}}, method, ball(1, 2, 3, Surd(0)));
    worked({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, method, ball(1, 2, 3, Surd(0)));
    worked({{-0.0, 0, 0}, {0, -0.0, 0}}, method, ball(0, 0, 0, Surd(0)));
  }
}

TEST_CASE("bounding_sphere: p. 31-34's methods worked by hand") {
  // The box is [0, 8] x [0, 3]: its center (4, 1.5) is sqrt(16 + 2.25) from the lower corners.
  worked(quadrilateral, box, ball(4, Rational(3, 2), 0, root(Rational(73, 4))), "rounding");
  // The mean is (4, 1): sqrt(16 + 1).
  worked(quadrilateral, centroid, ball(4, 1, 0, root(17)));
  // Around (0, 0) - (8, 0), the widest pair; the others are inside.
  worked(quadrilateral, ritter, ball(4, 0, 0, Surd(4)));
  worked(quadrilateral, smallest, ball(4, 0, 0, Surd(4)));
  // The pair (-3, 0), (3, 0); (0, 4) is 4 from its center: (3 + 4) / 2, and half of the way (0, 1) from 3 to 4.
  worked({{-3, 0, 0}, {3, 0, 0}, {0, 4, 0}}, ritter, ball(0, Rational(1, 2), 0, Surd(Rational(7, 2))));
  // The circle through the three: 9 + y^2 = (4 - y)^2.
  worked({{-3, 0, 0}, {3, 0, 0}, {0, 4, 0}}, smallest, ball(0, Rational(7, 8), 0, Surd(Rational(25, 8))));
}

TEST_CASE("bounding_sphere: the smallest ball rests on two, three or four points, also of many at once") {
  worked({{1, 2, 2}, {-1, -2, -2}, {2, 2, 1}}, smallest, ball(0, 0, 0, Surd(3)));
  // A right angle is on the boundary, not needed; an obtuse one is inside.
  worked({{0, 0, 0}, {4, 0, 0}, {0, 2, 0}}, smallest, ball(2, 1, 0, root(5)));
  worked({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}, smallest, ball(2, 0, 0, Surd(2)));
  // A regular tetrahedron, and all corners of its cube.
  const Points tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  worked(tetrahedron, smallest, ball(0, 0, 0, root(3)), "rounding");
  Points cube = tetrahedron;
  for (const Point3d& p : tetrahedron) cube.push_back({-p.x, -p.y, -p.z});
  worked(cube, smallest, ball(0, 0, 0, root(3)), "rounding");
  // On one line: its ends.
  worked({{1, 1, 1}, {3, 5, 5}, {2, 3, 3}, {0, -1, -1}, {2, 3, 3}}, smallest,
         ball(Rational(3, 2), 2, 2, Surd(Rational(9, 2))));
}

TEST_CASE("bounding_sphere: huge, subnormal and beside one another") {
  worked({{-greatest, 0, 0}, {greatest, 0, 0}}, box, ball(0, 0, 0, Surd(exact(greatest))), "rounding");
  worked({{0, 0, 0}, {tiny, 0, 0}}, smallest, ball(exact(tiny) / 2, 0, 0, Surd(exact(tiny) / 2)), "rounding");
  // Nothing finite holds both ends of a diagonal of the whole range.
  const Points corners{{-greatest, -greatest, -greatest}, {greatest, greatest, greatest}};
  CHECK(std::isinf(robust::bounding_sphere(corners).radius));
  CHECK(robust::bounding_sphere({{-greatest, 0, 0}, {greatest, 0, 0}}).radius == greatest);
  // The center (1 + 2^-53, 0, 0) rounds to 1: then the radius reaches farther than half of the way, by half of an ulp
  // of 1, as no double less does.
  const Sphere3d rounded = robust::bounding_sphere({{1, 0, 0}, {1 + 0x1p-52, 0, 0}});
  CHECK(rounded.center == Point3d{1, 0, 0});
  CHECK(rounded.radius == 0x1p-52);
}

TEST_CASE("bounding_sphere: the checker says which point is lost, and by how much") {
  const Points pair{{-1, 0, 0}, {1, 0, 0}};
  for (const SphereMethod method : {box, centroid, ritter, smallest}) {
    CHECK(defect(pair, method, {{0, 0, 0}, 1}).empty());
    CHECK(defect(pair, method, {{0, 0, 0}, 1 + 0x1p-52}).empty());
    CHECK(defect(pair, method, {{0x1p-60, 0, 0}, 1}) ==
          "point 0 is outside by 8.67e-19, 0.00391 units in the last place of the radius");
    CHECK(defect(pair, method, {{0, 0, 0}, 1 - 0x1p-53}) ==
          "point 0 is outside by 1.11e-16, 1 units in the last place of the radius");
    CHECK(defect(pair, method, {{0, 0, 0}, 0}) == "point 0 is outside by 1");
    CHECK(defect(pair, method, {{0, 0, 0}, 1.6}).find("the radius is too large, by 0.") == 0);
    CHECK(defect(pair, method, {{0, 0, 0}, infinity}) == "the radius is infinite, and a finite one is large enough");
    CHECK(defect(pair, method, {{0, 0, 0}, not_a_number}) == "the radius is no number, or negative");
    CHECK(defect(pair, method, {{0, 0, 0}, -1}) == "the radius is no number, or negative");
    CHECK(defect(pair, method, {{0, infinity, 0}, 1}) == "the center is not finite");
  }
  // Another ball of that radius, or nearly, is as good: what it holds is asked, not where it is.
  CHECK(defect(pair, smallest, {{0, 0x1p-53, 0}, 1 + 0x1p-52}).empty());
  CHECK(!defect(pair, smallest, {{0, 0, 0}, 1 + 0x1p-48}).empty());
  CHECK(defect(pair, ritter, {{0, 0, 0}, 1.5}).empty());
}

TEST_CASE("bounding_sphere: no point is refused by the field") {
  refused<Row>({Points{}, smallest}, "points", "at least 1 point");
  refused<Row>({Points{}, std::nullopt}, "points", "at least 1 point");
}

CONTRACT("bounding_sphere: the formula in double keeps its contract", points, method) {
  const auto& [x, y, z] = answer.center;
  if (method != box || !finite(x, y, z)) return true;
  Rational square = 0;
  double computed = 0;
  for (const Point3d& p : points) {
    square = std::max(square, squared_distance(answer.center, p));
    const Vector3d displacement = p - answer.center;
    computed = std::max(computed, dot(displacement, displacement));
  }
  if (square < power_of_two(-900) || !finite(computed)) return true;
  const Rational radius = exact(answer.radius), part = 4 * unit();
  return radius * radius <= square * (1 + part) * (1 + part) && radius * radius >= square * (1 - part) * (1 - part);
}

}  // namespace touchstone::proptests::bounding_sphere_tests
