// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/capsules.h"
#include "proptests/half_space_laws.h"
#include "proptests/motion_laws.h"

/// Laws of a ball or a capsule that moves towards a plane, the thin set, not the half-space behind it.
namespace touchstone::proptests {

inline std::vector<Point3d> ends_of(const Sphere3d& ball) { return {ball.center}; }
inline std::vector<Point3d> ends_of(const Capsule3d& capsule) { return {capsule.segment.a, capsule.segment.b}; }

inline Rational sum_of_products(const Vector3d& v, double x, double y, double z) {
  return Rational(exact(v.x) * exact(x) + exact(v.y) * exact(y) + exact(v.z) * exact(z));
}

/// The least E^2 of an end at t, less r^2 N . N; if ends are on both sides, 0 less that: at most 0 where the solid
/// meets the plane.
template <class Solid>
oracle::Surd beyond(const std::tuple<Solid, Vector3d, Plane3d>& question, const oracle::Surd& t) {
  using oracle::Surd;
  const auto& [solid, v, plane] = question;
  const Vector3d& n = plane.normal;
  const Surd reach(Rational(exact(solid.radius) * exact(solid.radius) * sum_of_products(n, n.x, n.y, n.z)));
  std::vector<Surd> heights;
  for (const Point3d& p : ends_of(solid))
    heights.push_back(Surd(Rational(sum_of_products(n, p.x, p.y, p.z) + exact(plane.offset))) +
                      t * Surd(sum_of_products(n, v.x, v.y, v.z)));
  const Surd &first = heights.front(), &last = heights.back();
  if (sgn(first) != sgn(last)) return Surd(Rational(0)) - reach;
  return std::min(first * first, last * last) - reach;
}

template <class Number>
bool is_zero_time(const Number& t) {
  return t == Number(Rational(0));
}
inline bool is_zero_time(double t) { return t == 0; }

/// What swept_sphere_plane's contract promises of the formula for a ball.
inline bool keeps_contract_of_approach(const Sphere3d& sphere, const Vector3d& v, const Plane3d& plane,
                                       const FirstContact<double>& answer, const FirstContact<oracle::Surd>& truth) {
  using oracle::Surd;
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
    return answer.relation == HitRelation::never && truth.relation == HitRelation::never;
  if (!(exact(t) > error && exact(t) < 1 - error)) return true;
  return answer.relation == HitRelation::hit && truth.relation == HitRelation::hit &&
         Surd(Rational(exact(t) - error)) <= *truth.t && *truth.t <= Surd(Rational(exact(t) + error));
}

/// At the exact t the nearest end is as far from the plane as the radius, and was farther before.
inline constexpr auto first_at_plane = [](const auto& ask, const auto& asked) {
  using oracle::Surd;
  const auto answer = ask(asked);
  const Surd nothing{Rational(0)}, start = beyond(asked, Rational(0)), end = beyond(asked, Rational(1));
  if (!answer.t) return start > nothing && end > nothing;
  if (sgn(*answer.t) == 0) return start <= nothing;
  return start > nothing && sgn(beyond(asked, *answer.t)) == 0 && sgn(*answer.t) > 0 &&
         *answer.t <= Surd(Rational(1)) && beyond(asked, *answer.t * Surd(Rational(1, 2))) > nothing;
};

}  // namespace touchstone::proptests

/// Their test cases, in the types of the file's `Row`.
#define PLANE_SWEEP_LAWS(op, solid)                                                                                   \
  EQUATION_LAW(op, 2)                                                                                                 \
  VELOCITIES_LAW(op, 1)                                                                                               \
  LAW(op ": a plane has two sides alike", solid, velocity, plane) {                                                   \
    return equal(ask(Row::Question{solid, velocity, {-1.0 * plane.normal, -plane.offset}}), ask(asked));              \
  }                                                                                                                   \
  LAW(op ": a larger radius never meets later", solid, velocity, plane) {                                             \
    const auto answer = ask(asked);                                                                                   \
    for (const double larger : {catalogue::moved_by_ulps(solid.radius, 1), solid.radius + solid.radius / 4 + tiny}) { \
      if (!finite(larger)) continue;                                                                                  \
      auto thicker = solid;                                                                                           \
      thicker.radius = larger;                                                                                        \
      const auto then = ask(Row::Question{thicker, velocity, plane});                                                 \
      if (answer.t && (!then.t || *then.t > *answer.t)) return false;                                                 \
    }                                                                                                                 \
    return true;                                                                                                      \
  }                                                                                                                   \
  LAW(op ": along the plane and at rest, it is met at the start or never", solid, velocity, plane) {                  \
    const auto rest = ask(Row::Question{solid, {0, 0, 0}, plane});                                                    \
    const bool meet = sgn(beyond(asked, oracle::Surd(Rational(0)))) <= 0;                                             \
    if (rest.t.has_value() != meet || (meet && !is_zero_time(*rest.t))) return false;                                 \
    const Vector3d& n = plane.normal;                                                                                 \
    if (n.x != 0 && !equal(ask(Row::Question{solid, {0, n.z, -n.y}, plane}), rest)) return false;                     \
    return !meet || equal(ask(asked), rest);                                                                          \
  }                                                                                                                   \
  TEST_CASE(op ": at the exact t it is as far from the plane as the radius, and was farther before") {                \
    law_of<Row>(                                                                                                      \
        "oracle: first contact", [](const auto& asked) { return catalogue::ask_oracle<Row>(asked).answer; },          \
        first_at_plane, 3);                                                                                           \
  }                                                                                                                   \
  TEST_CASE(op ": in exact arithmetic the formula is wrong only of what meets the plane at the start") {              \
    right_but_at_the_start<Row>();                                                                                    \
  }
