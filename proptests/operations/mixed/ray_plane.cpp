// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/ray_plane.h"

#include "proptests/ray_laws.h"
#include "robust/mixed/segment_plane.h"

namespace touchstone::proptests::ray_plane_tests {
namespace {

using Row = rows::ray_plane;
using namespace plane_passages;

constexpr Worked<Row> worked;

Vector3d backwards(const Vector3d& v) { return -1.0 * v; }

}  // namespace

PLANE_PASSAGE_LAWS("ray_plane")

LAW("ray_plane: of a ray and its opposite one at most meets the plane, but for the origin and all of it", ray, plane) {
  const auto answer = ask(asked), found = ask(Row::Question{{ray.origin, backwards(ray.direction)}, plane});
  if (answer.relation == Relation::inside) return found.relation == Relation::inside;
  if (answer.relation == Relation::none || found.relation == Relation::none) return true;
  return *answer.t == 0 && *found.t == 0 && equal(answer.point, found.point);
}

LAW("ray_plane: a direction times a power of two reaches the same point, t divided by it", ray, plane) {
  const auto answer = ask(asked);
  for (const int k : {1, -29, 300}) {
    const auto& [x, y, z] = ray.direction;
    const Vector3d longer{std::ldexp(x, k), std::ldexp(y, k), std::ldexp(z, k)};
    const double back[]{std::ldexp(longer.x, -k), std::ldexp(longer.y, -k), std::ldexp(longer.z, -k)};
    if (back[0] != x || back[1] != y || back[2] != z) continue;
    const auto found = ask(Row::Question{{ray.origin, longer}, plane});
    if (found.relation != answer.relation || !equal(found.point, answer.point)) return false;
    if (answer.t && !scaled_number(*answer.t, *found.t, -k)) return false;
  }
  return true;
}

ROBUST_LAW("ray_plane: on the lattice a ray meets what the segment of its direction meets, at the same t", ray, plane) {
  if (!on_small_lattice(asked)) return true;
  const auto answer = ask(asked), part = robust::segment_plane({ray.origin, ray.origin + ray.direction}, plane);
  return part.relation == Relation::none ? !answer.t || *answer.t >= 1 : equal(answer, part);
}

TEST_CASE("ray_plane: -E0 / R worked by hand; margin: the origin's height, or the rise") {
  worked({{{0, 3, 0}, {4, -1, 8}}, ground}, at(3, {12, 0, 24}), 1);
  worked({{{0, -3, 0}, {4, 6, 8}}, ground}, at(Rational(1, 2), {2, 0, 4}), 9);  // from behind
  worked({{{3, 3, 3}, {0, 0, -2}}, {{2, 1, 2}, -9}}, at(Rational(3, 2), {3, 3, 0}), Rational(16, 9));
  worked({{{0, 3, 0}, {4, 1, 8}}, ground}, none, 1);  // away
  worked({{{0, -3, 0}, {4, -5, 8}}, ground}, none, 9);
  worked({{{0, 1, 0}, {4, 0, 8}}, ground}, none, 0);  // along it: the least change of the direction meets it
}

TEST_CASE("ray_plane: an origin on the plane is a point, all of it is inside") {
  worked({{{7, 0, 0}, {4, 1, 8}}, ground}, at(0, {7, 0, 0}), 0);
  worked({{{7, 0, 0}, {4, -1, 8}}, ground}, at(0, {7, 0, 0}), 0);
  worked({{{7, 0, 0}, {1, 0, 0}}, ground}, inside, 0, "algorithm");  // R = 0
  worked({{{3, 3, 0}, {1, -2, 0}}, {{2, 1, 2}, -9}}, inside, 0, "algorithm");
}

TEST_CASE("ray_plane: rounding meets a plane that the ray leaves") {
  // 10 times the double 0.1 is 1 + 2^-54, which rounds to 1: on the plane, says E0.
  worked({{{0.1, 0, 0}, {1, 0, 0}}, {{10, 0, 0}, -1}}, none, power_of_two(-108) / 100, "rounding");
}

TEST_CASE("ray_plane: t beyond the range is infinite, and the point is where it is") {
  const Rational t = exact(huge) / exact(tiny);
  worked({{{0, huge, 0}, {tiny, -tiny, 0}}, ground}, at(t, {exact(huge), 0, 0}), exact(tiny) * exact(tiny), "invalid");
}

CONTRACT("ray_plane: the formula in double keeps its contract", ray, plane) {
  const auto& [origin, v] = ray;
  const HeightBound height(plane, origin), climb({plane.normal, 0}, {v.x, v.y, v.z});
  if (!height.certain() || !climb.certain()) return true;
  const Rational e0 = exact(height.computed), r = exact(climb.computed);
  if (!(abs(e0) > power_of_two(-1074) * abs(r))) return true;
  if (sgn(e0) == sgn(r)) return answer.relation == Relation::none && truth.answer.relation == Relation::none;
  if (answer.relation != Relation::point || truth.answer.relation != Relation::point) return false;
  if (!finite(*answer.t)) return true;
  const Rational error = error_of_quotient(*answer.t, height.error, climb.computed, climb.error);
  return within(*answer.t, *truth.answer.t, error) &&
         close_along(v, *answer.t, error, *answer.point, *truth.answer.point);
}

}  // namespace touchstone::proptests::ray_plane_tests
