// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proptests/space_laws.h"

/// Laws of rays and segments in space.
namespace touchstone::proptests {

inline Plane3d other_side(const Plane3d& plane) { return {-1.0 * plane.normal, -plane.offset}; }

template <class Row>
inline constexpr auto oracles = [](const auto& asked) { return catalogue::ask_oracle<Row>(asked).answer; };

inline constexpr auto exact_point_on_plane = [](const auto& ask, const auto& asked) {
  const auto answer = ask(asked);
  if (!answer.point) return true;
  const auto& [n, offset] = std::get<1>(asked);
  const auto& [x, y, z] = *answer.point;
  return sgn(Rational(exact(n.x) * x + exact(n.y) * y + exact(n.z) * z + exact(offset))) == 0;
};

/// By how much t = -E0 / R as computed, for E0 and R that are off by so much, is off (reference/mixed/ray_plane.h).
inline Rational error_of_quotient(double t, const Rational& of_e0, double r, const Rational& of_r) {
  const Rational u = unit(), size = abs(exact(t)), rounded = 2 * u * size + power_of_two(-1074);
  return (of_e0 + (size + rounded) * of_r) / (abs(exact(r)) - of_r) + rounded;
}

/// Whether a point that is computed as origin + t direction is as near as that to the truth, as far as nothing
/// overflows.
inline bool close_along(const Vector3d& direction, double t, const Rational& error, const Point3d& computed,
                        const Point3<Rational>& truth) {
  const auto close = [&](double v, double x, const Rational& right) {
    if (!finite(t * v, x)) return true;
    const Rational rounding = 2 * unit() * (size(t) * size(v) + size(x)) + power_of_two(-1074);
    return within(x, right, size(v) * error + rounding);
  };
  return close(direction.x, computed.x, truth.x) && close(direction.y, computed.y, truth.y) &&
         close(direction.z, computed.z, truth.z);
}

/// Words of worked examples.
namespace plane_passages {
using Relation = LinePlaneRelation;
inline const LinePlane<Rational> none{Relation::none, {}, {}}, inside{Relation::inside, {}, {}};
inline LinePlane<Rational> at(const Rational& t, const Point3<Rational>& point) { return {Relation::point, t, point}; }
inline constexpr Plane3d ground{{0, 1, 0}, 0};
}  // namespace plane_passages

/// PLANE_PASSAGE_LAWS("ray_plane") is three test cases, in the types of the file's `Row`.
#define PLANE_PASSAGE_LAWS(operation)                                                         \
  EQUATION_LAW(operation, 1)                                                                  \
  LAW(operation ": seen from its other side the plane has the same in common", line, plane) { \
    return equal(ask(asked), ask(Row::Question{line, other_side(plane)}));                    \
  }                                                                                           \
  TEST_CASE(operation ": the exact point is on the plane") {                                  \
    law_of<Row>("oracle: the point", oracles<Row>, exact_point_on_plane, 3);                  \
  }

}  // namespace touchstone::proptests
