// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/obb_of_points.h"

#include "proptests/space_laws.h"
#include "robust/volumes/obb_obb.h"
#include "robust/volumes/point_in_obb.h"

namespace touchstone::proptests::obb_of_points_tests {
namespace {

using Row = rows::obb_of_points;
using Points = Row::Points;
using ExactBox = Obb3<Rational>;

/// The corners of center + r u + s v + t w.
Points corners(const Obb3d& box) {
  Points points;
  for (const double r : {-2.0, 2.0})
    for (const double s : {-2.0, 2.0})
      for (const double t : {-2.0, 2.0}) points.push_back(catalogue::halves_along(box, r, s, t));
  return points;
}

bool parallel(const Vector3<Rational>& a, const Vector3<Rational>& b) {
  const Vector3<Rational> n = cross(a, b);
  return n.x == 0 && n.y == 0 && n.z == 0;
}

/// The truth has these half axes, in any order, each perhaps turned over.
void worked(const Points& points, const Point3<Rational>& center, const std::vector<Vector3<Rational>>& half_axes) {
  const ExactBox truth = catalogue::ask_oracle<Row>(Row::Question{points}).answer;
  CHECK(truth.center == center);
  const auto& [u, v, w] = truth.half_axes;
  for (const auto& a : {u, v, w})
    CHECK(std::any_of(half_axes.begin(), half_axes.end(),
                      [&a](const auto& b) { return parallel(a, b) && dot(a, a) == dot(b, b); }));
  CHECK(Row::exact_defect({points}, truth) == "");
  CHECK(Row::defect({points}, robust::obb_of_points(points)) == "");
}

std::string defect(const Points& points, const Obb3d& box) { return Row::defect({points}, box); }

/// The box with every half axis times a power of two.
Obb3d scaled(Obb3d box, int k) {
  catalogue::walk(
      box, [k](double& number) { number = std::ldexp(number, k); }, [](auto&) {});
  return box;
}

}  // namespace

ROBUST_LAW("obb_of_points: no point is outside, by point_in_obb, and the box meets itself", points) {
  const Obb3d box = ask(asked);
  return robust::obb_obb(box, box) == Contact::overlapping &&
         std::all_of(points.begin(), points.end(),
                     [&box](const Point3d& p) { return robust::point_in_obb(box, p) != Location::outside; });
}

ROBUST_LAW("obb_of_points: points times a power of two have the box times that power") {
  Points points = std::get<0>(asked);
  bool ordinary = true;  // nothing is rounded at either end of the range
  for (const Point3d& p : points)
    for (const double x : {p.x, p.y, p.z}) ordinary = ordinary && (x == 0 || (size(x) > 0x1p-700 && size(x) < 0x1p700));
  if (!ordinary) return true;
  const Obb3d box = ask(asked);
  for (Point3d& p : points) p = {std::ldexp(p.x, -37), std::ldexp(p.y, -37), std::ldexp(p.z, -37)};
  const Obb3d other = ask(std::tuple(points));
  const auto& [u, v, w] = box.half_axes;
  return equal(other, scaled(box, -37)) || (u.x == tiny || v.y == tiny || w.z == tiny);  // which none can be less than
}

TEST_CASE("obb_of_points: the truth is right, and so is the formula in exact arithmetic") {
  robust_law<Row>(
      "exactly right",
      [](const auto&, const auto& asked) {
        const catalogue::RowFunctions& row = catalogue::operation_of_row<Row>().row();
        const auto formula = row.reference_exactly(catalogue::packed(asked));
        const auto exactly = [](const catalogue::Exact& n) { return n.value(); };
        return Row::exact_defect(asked, catalogue::ask_oracle<Row>(asked).answer).empty() &&
               row.exact_defect(catalogue::packed(asked), catalogue::encoded_with<mpq_class>(formula, exactly)).empty();
      },
      3);
}

TEST_CASE("obb_of_points: boxes worked by hand") {
  // The corners of a box turned by the triple 3, 4, 5: the covariance has its axes.
  const Obb3d box{{1, 2, 3}, {{12, 16, 0}, {-4, 3, 0}, {0, 0, 2}}};
  worked(corners(box), {1, 2, 3}, {{12, 16, 0}, {-4, 3, 0}, {0, 0, 2}});
  // The same with a point in the middle of a face, which changes no axis here.
  Points more = corners(box);
  more.push_back({13, 18, 3}), more.push_back({-11, -14, 3});
  worked(more, {1, 2, 3}, {{12, 16, 0}, {-4, 3, 0}, {0, 0, 2}});
  // In a plane: the corners of a rectangle. On a line: its ends. One point, and equal points.
  worked({{0, 0, 0}, {4, 4, 0}, {3, 5, 0}, {-1, 1, 0}}, {Rational(3, 2), Rational(5, 2), 0},
         {{2, 2, 0}, {Rational(-1, 2), Rational(1, 2), 0}, {0, 0, 0}});
  worked({{1, 1, 1}, {3, 5, 5}, {2, 3, 3}, {0, -1, -1}, {2, 3, 3}}, {Rational(3, 2), 2, 2},
         {{Rational(3, 2), 3, 3}, {0, 0, 0}});
  worked({{0.5, 2, -1}}, {Rational(1, 2), 2, -1}, {{0, 0, 0}});
  worked({{0.5, 2, -1}, {0.5, 2, -1}}, {Rational(1, 2), 2, -1}, {{0, 0, 0}});
}

TEST_CASE("obb_of_points: robust's boxes have a thickness, be the points in one plane, on one line, equal") {
  const Obb3d point = robust::obb_of_points({{1, 2, 3}, {1, 2, 3}});
  CHECK(point.center == Point3d{1, 2, 3});
  CHECK(equal(point.half_axes, HalfAxes<double>{{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}));
  for (const Points& flat : {Points{{0, 0, 0}, {4, 4, 0}, {3, 5, 0}, {-1, 1, 0}}, Points{{1, 1, 1}, {3, 5, 5}},
                             Points{{tiny, 0, tiny}, {3 * tiny, tiny, 0}}, Points{{0, 0, 0}}}) {
    const Obb3d box = robust::obb_of_points(flat);
    CHECK(defect(flat, box) == "");
    CHECK(robust::point_in_obb(box, flat[0]) != Location::outside);
  }
}

TEST_CASE("obb_of_points: huge and subnormal") {
  const Points ends{{-greatest, -greatest, -greatest}, {greatest, greatest, greatest}};
  const Obb3d widest = robust::obb_of_points(ends);
  CHECK(equal(widest, Obb3d{{0, 0, 0}, {{greatest, 0, 0}, {0, greatest, 0}, {0, 0, greatest}}}));
  CHECK(defect(ends, widest) == "");
  const Points least{{0, 0, 0}, {tiny, 3 * tiny, 0}};
  const Obb3d smallest = robust::obb_of_points(least);
  CHECK(equal(smallest, Obb3d{{0, 2 * tiny, 0}, {{tiny, 0, 0}, {0, 2 * tiny, 0}, {0, 0, tiny}}}));
  CHECK(defect(least, smallest) == "");
}

TEST_CASE("obb_of_points: the checker says which point is lost, and what else is wrong") {
  const Points pair{{-1, 0, 0}, {1, 0, 0}}, uneven{{-0.5, 0, 0}, {1, 0, 0}};
  const auto box = [](double x, double y, double z) { return Obb3d{{0, 0, 0}, {{x, 0, 0}, {0, y, 0}, {0, 0, z}}}; };
  const double above = 1 + 0x1p-52, below = 1 - 0x1p-53;
  CHECK(defect(pair, box(1, tiny, tiny)) == "");
  CHECK(defect(pair, box(-above, 0, 0)) == "");  // flat, and turned over
  CHECK(defect(uneven, box(below, 0, 0)) == "points[1] is outside, beyond half_axes[0], by 1.11e-16");
  CHECK(defect(uneven, box(0, 1, 1)) == "points[1] is outside, across the half axes that are not 0, by 1");
  CHECK(defect(uneven, box(0, 0, 0)) == "points[1] is outside, across the half axes that are not 0, by 1");
  CHECK(defect(pair, {{0, tiny, 0}, box(1, 0, 0).half_axes}) ==
        "points[0] is outside, across the half axes that are not 0, by 4.941e-324");
  CHECK(defect(pair, {{0, tiny, 0}, box(1, tiny, tiny).half_axes}) == "");
  CHECK(defect(pair, box(1, 0x1p-43, 0)) == "");
  CHECK(defect(pair, box(1, 0x1p-42, 0)) ==
        "half_axes[1]: a face is beyond all points by 2.274e-13, allowed are 1.137e-13");
  CHECK(defect(pair, {{1, 0, 0}, box(2, tiny, tiny).half_axes}) ==
        "half_axes[0]: a face is beyond all points by 2, allowed are 1.137e-13");
  CHECK(defect(pair, box(infinity, tiny, tiny)) == "a half axis is not finite");
  CHECK(defect(pair, {{0, not_a_number, 0}, box(1, 0, 0).half_axes}) == "the center is not finite");
  CHECK(defect(pair, {{0, 0, 0}, {{1, 0, 0}, {2, 0, 0}, {0, 0, 1}}}) == "the half axes are linearly dependent");
  CHECK(defect(pair, {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}) == "the half axes are linearly dependent");
  // A rhombus on its longer diagonal: it touches the points, and is none the less far too large.
  CHECK(defect({{-1, -1, 0}, {1, 1, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}) == "");
  CHECK(defect({{-1, -1, 0}, {1, 1, 0}}, {{0, 0, 0}, {{0.5, 0, 0}, {0.5, 1, 0}, {0, 0, 0}}}) ==
        "the half axes are not at right angles");
  const double turn = 0x1p-20;
  CHECK(defect(pair, {{0, 0, 0}, {{1, 0, 0}, {tiny, tiny, 0}, {0, 0, tiny}}}) ==
        "");  // subnormal numbers have no angles
  const Points square{{-1 - turn, -1, 0}, {1 + turn, 1, 0}, {-1 + turn, 1, 0}, {1 - turn, -1, 0}};
  CHECK(defect(square, {{0, 0, 0}, {{1, 0, 0}, {turn, 1, 0}, {0, 0, 0}}}) == "");
}

TEST_CASE("obb_of_points: a lost point is the formula's rounding, and the verdict says which and by how much") {
  const auto judged =
      examined<Row>({{{0, 0, 0}, {0.1, 0.2, 0.3}, {0.3, 0.1, 0.2}, {0.7, 0.7, -0.1}}})->judge_reference();
  CHECK(judged.verdict == catalogue::Verdict::rounding);
  CHECK(judged.remark.find("is outside, beyond half_axes[") != std::string::npos);
}

CONTRACT("obb_of_points: what the formula in double loses is within its contract", points) {
  const auto& box = answer;
  Rational room = 0;
  bool ordinary = true;
  for (const Point3d& p : points)
    for (const double x : {p.x, p.y, p.z}) {
      ordinary = ordinary && (x == 0 || size(x) > power_of_two(-400)) && size(x) < power_of_two(500);
      room = std::max(room, Rational(size(x) * power_of_two(-43)));
    }
  const auto& [u, v, w] = box.half_axes;
  const auto exactly = [](const Vector3d& a) { return Vector3<Rational>{exact(a.x), exact(a.y), exact(a.z)}; };
  const Vector3<Rational> axes[] = {exactly(u), exactly(v), exactly(w)};
  if (!ordinary || dot(axes[0], cross(axes[1], axes[2])) == 0) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3<Rational> n = cross(axes[(k + 1) % 3], axes[(k + 2) % 3]);
    for (const Point3d& p : points) {
      const Vector3<Rational> displacement =
          exactly({p.x, p.y, p.z}) - exactly({box.center.x, box.center.y, box.center.z});
      const Rational beyond(abs(dot(n, displacement)) - abs(dot(n, axes[k])));
      if (beyond > 0 && beyond * beyond > room * room * dot(n, n)) return false;
    }
  }
  return true;
}

}  // namespace touchstone::proptests::obb_of_points_tests
