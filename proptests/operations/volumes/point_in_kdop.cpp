// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/point_in_kdop.h"

#include "proptests/space_laws.h"
#include "robust/planes/point_plane.h"

namespace touchstone::proptests::point_in_kdop_tests {
namespace {

using Row = rows::point_in_kdop;

constexpr Location inside = Location::inside, boundary = Location::boundary, outside = Location::outside;
/// 0 <= x <= 4, -1 <= x + y + z <= 6
const Kdop3d wedge{{{1, 0, 0}, {1, 1, 1}}, {{0, 4}, {-1, 6}}};

Kdop3d one_slab(const Vector3d& normal, double min, double max) { return {{normal}, {{min, max}}}; }
Kdop3d one_slab(const Kdop3d& kdop, std::size_t i) { return {{kdop.normals[i]}, {kdop.slabs[i]}}; }

constexpr Worked<Row> worked;

/// Beyond the error bound of the contract from both ends.
bool certain(const Vector3d& n, const Slabd& slab, const Point3d& p) {
  const double x = n.x * p.x, y = n.y * p.y, z = n.z * p.z, value = x + y + z;
  if (!finite(x, y, z, x + y, value)) return false;
  const Rational u = unit(), e = (3 + 8 * u) * u * (size(x) + size(y) + size(z)) + power_of_two(-1073);
  return abs(exact(value) - exact(slab.min)) > e && abs(exact(value) - exact(slab.max)) > e;
}

}  // namespace

LAW("point_in_kdop: the location is the last, in the order inside, boundary, outside, of those in the slabs", kdop, p) {
  Location last = inside;
  for (std::size_t i = 0; i < kdop.normals.size(); ++i)
    last = std::max<Location>(last, ask(std::tuple(one_slab(kdop, i), p)));
  return ask(asked) == last;
}

LAW("point_in_kdop: the order of the slabs does not matter, nor that one is there twice") {
  auto [kdop, p] = asked;
  std::reverse(kdop.normals.begin(), kdop.normals.end()), std::reverse(kdop.slabs.begin(), kdop.slabs.end());
  kdop.normals.push_back(kdop.normals[0]), kdop.slabs.push_back(kdop.slabs[0]);
  return ask(std::tuple(kdop, p)) == ask(asked);
}

LAW("point_in_kdop: a slab may be written with the opposite normal") {
  auto [kdop, p] = asked;
  for (Vector3d& n : kdop.normals) n = {-n.x, -n.y, -n.z};
  for (Slabd& slab : kdop.slabs) slab = {-slab.max, -slab.min};
  return ask(std::tuple(kdop, p)) == ask(asked);
}

LAW("point_in_kdop: a normal and its slab times a power of two say the same") {
  const auto times = [](Kdop3d kdop, int k) {
    catalogue::for_each_number(kdop, [k](double& number) { number = std::ldexp(number, k); });
    return kdop;
  };
  const auto& [kdop, p] = asked;
  for (const int k : {1, -40, 500, -500}) {
    const Kdop3d longer = times(kdop, k);
    if (numbers_of(times(longer, -k)) == numbers_of(kdop) && ask(std::tuple(longer, p)) != ask(asked)) return false;
  }
  return true;
}

LAW("point_in_kdop: flat slabs at an end of a slab hold the point at most on the boundary") {
  auto [kdop, p] = asked;
  for (Slabd& slab : kdop.slabs) slab.max = slab.min;
  const Location flat = ask(std::tuple(kdop, p));
  return flat != inside && (flat == outside || ask(asked) == boundary);
}

ROBUST_LAW("point_in_kdop: p. 22's planes say of each end on which side the point lies", kdop, p) {
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    const auto over = robust::point_plane_side({kdop.normals[i], -kdop.slabs[i].min}, p),
               beyond = robust::point_plane_side({kdop.normals[i], -kdop.slabs[i].max}, p);
    const bool excluded = over == PlaneSide::back || beyond == PlaneSide::front;
    const bool at_end = over == PlaneSide::on || beyond == PlaneSide::on;
    if (ask(std::tuple(one_slab(kdop, i), p)) != (excluded ? outside : at_end ? boundary : inside)) return false;
  }
  return true;
}

TEST_CASE("point_in_kdop: p. 43's slabs worked by hand") {
  worked({wedge, {1, 2, 0.5}}, inside, 1);                                  // x = 1: 1 from 0; sum 3.5: 2.5^2 / 3
  worked({wedge, {2, 2, 1}}, inside, Rational(1, 3));                       // sum 5: 1 from 6
  worked({wedge, {4, 1, 0}}, boundary, 0);                                  // x = 4
  worked({wedge, {0, -1, 0}}, boundary, 0);                                 // an edge: x = 0, sum -1
  worked({wedge, {5, 0, 0}}, outside, 1);                                   // x = 5
  worked({wedge, {2, 2, 3}}, outside, Rational(1, 3));                      // sum 7
  worked({wedge, {5, 5, 5}}, outside, 27);                                  // sum 15, 9 beyond: 81 / 3; x is 1 beyond
  worked({wedge, {4, 2, 2}}, outside, Rational(4, 3));                      // at one end, sum 8
  worked({one_slab({0, 0, 2}, 3, 3), {9, 9, 1.5}}, boundary, 0);            // flat
  worked({one_slab({0, 0, 2}, 3, 3), {9, 9, 2}}, outside, Rational(1, 4));  // 1 beyond, 1 / 4
  worked({{{{1, 0, 0}, {1, 0, 0}}, {{0, 1}, {2, 3}}}, {1.5, 0, 0}}, outside, Rational(1, 4));  // an empty solid
  worked({{{{1, 0, 0}, {-1, 0, 0}}, {{0, 1}, {-2, -1}}}, {1, 0, 0}}, boundary, 0);  // slabs that touch: the plane x = 1
}

TEST_CASE("point_in_kdop: where the sum of products rounds to an end") {
  // 0.1 * 3 is 0.3 as typed; 3 times the double 0.1 is 0x1.3333333333333_4p-2, halfway to the next above 0.3's double.
  const Rational beyond = 3 * exact(0.1) - exact(0.3);
  worked({one_slab({3, 0, 0}, 0, 0.3), {0.1, 0, 0}}, outside, Rational(beyond * beyond / 9));
  worked({one_slab({1, 1, 0}, 0, 1), {1, 0x1p-60, 0}}, outside, power_of_two(-121), "rounding");
  worked({one_slab({1, 1, 0}, 0, 1), {1, -0x1p-60, 0}}, inside, power_of_two(-121), "rounding");
}

CONTRACT("point_in_kdop: the formula in double keeps its contract and is right in exact arithmetic", kdop, p) {
  for (std::size_t i = 0; i < kdop.normals.size(); ++i)
    if (!certain(kdop.normals[i], kdop.slabs[i], p)) return true;
  return answer == truth.answer;
}

TEST_CASE("point_in_kdop: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::point_in_kdop_tests
