// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_sphere_plane.h"

#include "proptests/motion_laws.h"
#include "proptests/space_laws.h"

namespace touchstone::proptests::swept_sphere_plane_tests {
namespace {

using Row = rows::swept_sphere_plane;
using Answer = exact_answer_t<Row>;
using oracle::Surd;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Surd& t) { return {HitRelation::hit, t}; }

constexpr Plane3d ground{{0, 1, 0}, 0};

/// A ball over the ground.
Row::Question over_ground(double height, double radius, double velocity) {
  return {{{3, height, -1}, radius}, {2, velocity, 5}, ground};
}

constexpr Worked<Row> worked;

bool zero(double t) { return t == 0; }
bool zero(const Surd& t) { return sgn(t) == 0; }

Rational sum_of_products(const Vector3d& v, double x, double y, double z) {
  return Rational(exact(v.x) * exact(x) + exact(v.y) * exact(y) + exact(v.z) * exact(z));
}

/// E of the center at t, squared, less r^2 N . N: at most 0 where ball and plane meet.
Surd beyond(const Row::Question& question, const Surd& t) {
  const auto& [sphere, v, plane] = question;
  const auto& [center, radius] = sphere;
  const Vector3d& n = plane.normal;
  const Rational start = sum_of_products(n, center.x, center.y, center.z) + exact(plane.offset),
                 reach = exact(radius) * exact(radius) * sum_of_products(n, n.x, n.y, n.z);
  const Surd height = Surd(start) + t * Surd(sum_of_products(n, v.x, v.y, v.z));
  return height * height - Surd(reach);
}

}  // namespace

TEST_CASE("swept_sphere_plane: powers of two, of lengths and of the plane, and exchanges of the axes keep the answer") {
  law<Row>("scales by powers of two", scales<Row>);
  law<Row>("the same plane", any_equation_of_the_plane<2>);
  law<Row>("axes", [](const auto& ask, const auto& asked) {
    const auto answer = ask(asked);
    return std::all_of(axis_maps.begin(), axis_maps.end(),
                       [&](const AxisMap& map) { return equal(ask(map(asked)), answer); });
  });
}

LAW("swept_sphere_plane: a plane has two sides alike", sphere, velocity, plane) {
  return equal(ask(Row::Question{sphere, velocity, {-1.0 * plane.normal, -plane.offset}}), ask(asked));
}

VELOCITIES_LAW("swept_sphere_plane", 1)

LAW("swept_sphere_plane: a larger ball never meets later", sphere, velocity, plane) {
  const auto answer = ask(asked);
  for (const double larger : {catalogue::moved_by_ulps(sphere.radius, 1), sphere.radius + sphere.radius / 4 + tiny}) {
    if (!finite(larger)) continue;
    const auto then = ask(Row::Question{{sphere.center, larger}, velocity, plane});
    if (answer.t && (!then.t || *then.t > *answer.t)) return false;
  }
  return true;
}

LAW("swept_sphere_plane: along the plane and at rest, it is met at the start or never", sphere, velocity, plane) {
  const auto rest = ask(Row::Question{sphere, {0, 0, 0}, plane});
  const bool meet = beyond(asked, Rational(0)) <= Surd(Rational(0));
  if (rest.t.has_value() != meet || (meet && !zero(*rest.t))) return false;
  const Vector3d& n = plane.normal;
  if (n.x != 0 && !equal(ask(Row::Question{sphere, {0, n.z, -n.y}, plane}), rest)) return false;
  return !meet || equal(ask(asked), rest);
}

TEST_CASE(
    "swept_sphere_plane: at the exact t the center is as far from the plane as the radius, and was farther before") {
  law_of<Row>(
      "oracle: first contact", [](const auto& asked) { return catalogue::ask_oracle<Row>(asked).answer; },
      [](const auto& ask, const auto& asked) {
        const auto answer = ask(asked);
        const Surd nothing{Rational(0)}, start = beyond(asked, Rational(0)), end = beyond(asked, Rational(1));
        if (!answer.t) return start > nothing && end > nothing;
        if (zero(*answer.t)) return start <= nothing;
        return start > nothing && sgn(beyond(asked, *answer.t)) == 0 && sgn(*answer.t) > 0 &&
               *answer.t <= Surd(Rational(1)) && beyond(asked, *answer.t * Surd(Rational(1, 2))) > nothing;
      },
      3);
}

TEST_CASE("swept_sphere_plane: p. 23's time worked by hand, from either side") {
  worked(over_ground(5, 2, -6), at(Rational(1, 2)), 5);     // 5 - 6 t = 2; 2^2 + 1^2: through the plane by 1
  worked(over_ground(-5, 2, 6), at(Rational(1, 2)), 5);     // from behind
  worked(over_ground(5, 2, -4), at(Rational(3, 4)), 3);     // 2^2 - 1^2
  worked(over_ground(5, 2, -2), misses, 5);                 // short of it: 2^2 - 3^2
  worked(over_ground(-5, 2, -3), misses, 21);               // behind the plane, and away from it: 2^2 - 5^2
  worked(over_ground(5, 2, 0), misses, 21);                 // along the ground
  worked(over_ground(5, 2, -40), at(Rational(3, 40)), 29);  // far through: the start is the nearer way out, 4 + 25
  // E = 6 + 12 + 12 + 6 = 36 of length 3 |N|: 12 away; falls by 9 a step; radius 6.
  worked({{{6, 6, 6}, 6}, {-3, -6, -6}, {{1, 2, 2}, 6}}, at(Rational(2, 3)), 27);
  // E = 3 - 4 t, |N| = sqrt(2): t = (3 - sqrt(2)) / 4; E ends at -1: 1 + 1 / 2.
  worked({{{3, 0, 0}, 1}, {-4, 0, 0}, {{1, 1, 0}, 0}}, at(Surd(Rational(3, 4), Rational(-1, 4), 2)), Rational(3, 2));
}

TEST_CASE("swept_sphere_plane: touching is a hit; a ball that meets the plane at the start is none for the formula") {
  worked(over_ground(5, 2, -3), at(Rational(1)), 0);               // at the very end
  worked(over_ground(2, 2, 1), at(Rational(0)), 0);                // it leaves: 0 / -1 is -0
  worked(over_ground(2, 2, -1), at(Rational(0)), 3);               // it goes deeper: 2^2 - 1^2
  worked(over_ground(2, 2, 0), at(Rational(0)), 0, "algorithm");   // along it: 0 / 0
  worked(over_ground(1, 2, -1), at(Rational(0)), 4, "algorithm");  // to the middle: -1
  worked(over_ground(1, 2, 5), at(Rational(0)), 3, "algorithm");   // -1 / -5: where it has left
  worked(over_ground(0, 2, 1), at(Rational(0)), 4, "algorithm");
  worked(over_ground(3, 0, -4), at(Rational(3, 4)), 1);           // a point goes through
  worked(over_ground(3, 0, -3), at(Rational(1)), 0);              // and just gets there
  worked(over_ground(0, 0, 0), at(Rational(0)), 0, "algorithm");  // in the plane: 0 / 0
}

TEST_CASE("swept_sphere_plane: rounding takes a ball beside the plane for one that touches it") {
  // 1 + 2^-60 high, radius 1.
  worked({{{1, 0, 0}, 1}, {0, 0, 0}, {{1, 0, 0}, 0x1p-60}}, misses, Rational(power_of_two(-59) + power_of_two(-120)));
  worked({{{1, 0, 0}, 1}, {1, 0, 0}, {{1, 0, 0}, 0x1p-60}}, misses, Rational(power_of_two(-59) + power_of_two(-120)),
         "rounding");  // 0 / -1
}

CONTRACT("swept_sphere_plane: the formula in double keeps its contract", sphere, v, plane) {
  const Vector3d& n = plane.normal;
  const HeightBound e(plane, sphere.center);
  const double q = dot(n, n), rise = dot(n, v);
  if (e.overflow || !(q >= 0x1p-960 && q <= 0x1p960) || !finite(rise, n.x * v.x, n.x * v.x + n.y * v.y)) return true;
  const double reach = sphere.radius * std::sqrt(q), gap = std::fabs(e.computed) - reach;
  const double fall = e.computed < 0 ? rise : -rise, t = gap / fall;
  if (!finite(reach, gap, t)) return true;
  const Rational u = unit(), terms = size(n.x * v.x) + size(n.y * v.y) + size(n.z * v.z);
  const Rational of_rise = (3 + 8 * u) * u * terms + power_of_two(-1073);
  const Rational of_gap = e.error + 6 * u * exact(reach) + u * size(gap) + power_of_two(-1073);
  if (!(exact(gap) > of_gap) || !(size(fall) > of_rise)) return true;
  const Rational error =
      (of_gap + (1 + 2 * u) * size(t) * of_rise) / (size(fall) - of_rise) + 2 * u * size(t) + power_of_two(-1074);
  if (t < 0 || exact(t) > 1 + error)
    return answer.relation == HitRelation::never && truth.answer.relation == HitRelation::never;
  if (!(exact(t) > error && exact(t) < 1 - error)) return true;
  return answer.relation == HitRelation::hit && truth.answer.relation == HitRelation::hit &&
         Surd(Rational(exact(t) - error)) <= *truth.answer.t && *truth.answer.t <= Surd(Rational(exact(t) + error));
}

TEST_CASE(
    "swept_sphere_plane: in exact arithmetic the formula is wrong of balls alone that meet the plane at the start") {
  right_but_at_the_start<Row>();
}

}  // namespace touchstone::proptests::swept_sphere_plane_tests
