// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/answers.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

/// The index of a point of the least height over a plane; so none of their hull is lower.
std::size_t lowest_of(const Hull& points, const Plane<Rational>& plane);

/// The contact of all that is no farther from the hull of points than a radius, and the half-space behind a plane: with
/// the lowest of these points, and the point of the half-space that is nearest to it, which is itself or the foot of
/// its perpendicular on the plane, and rational. The solids have a common point exactly if both are no farther apart
/// than the radius, and a common interior point exactly if they are nearer.
///
/// Margin: |S - r^2|, S being their squared distance.
///
/// Certificate, with the `point` of the half-space, and of several points the `weights` of the lowest: disjoint:
/// "nearest_point" (farther than the radius). touching: "tangent" (as far). overlapping: "common_interior_point".
Truth<Contact> contact_with_half_space(const Hull& core, const Rational& radius, const Plane<Rational>& plane);

/// Refuses an invalid shape or plane; numbers first.
template <class Shape, class Number>
void validate_over_plane(const std::string& field, const Shape& shape, const Plane<Number>& plane) {
  validation::validate_numbers(field, shape), validation::validate_numbers("plane", plane);
  validate_round(field, shape), validation::validate("plane", plane);
}

/// The same of a ball or capsule in its field.
template <class Shape, class Number>
Truth<Contact> contact_over_plane(const std::string& field, const Shape& shape, const Plane<Number>& plane) {
  validate_over_plane(field, shape, plane);
  const RoundSolid solid = round_solid(shape);
  return contact_with_half_space(solid.core, solid.radii[0], exact(plane));
}

/// When all that is no farther from the hull of points than a radius first meets a plane while it moves. With e the
/// height in units of |N|, at the start, of the point of the hull that is nearest to the plane, 0 if the hull has
/// points on both sides, it is when f(t) = (e + t N . velocity)^2 - r^2 N . N is first at most 0: f is a parabola,
/// whose first zero is found by Sturm's chain (parabola.h).
///
/// Margin: with m the lesser of r^2 + H |H| and r^2 - L |L|, H and L being the greatest and the least of the signed
/// distances of the points at the start and at the end: |m|.
///
/// Certificate: the kind that the parabola has (parabola.h), with its `polynomial`.
Truth<FirstContact<Surd>> first_contact_with_plane(const Hull& core, const Rational& radius,
                                                   const Vector3<Rational>& velocity, const Plane<Rational>& plane);

/// The same of a ball or capsule in its field; refuses invalid arguments.
template <class Shape, class Number>
Truth<FirstContact<Surd>> sweep_to_plane(const char* field, const Shape& shape, const Vector3<Number>& v,
                                         const Plane<Number>& plane) {
  validation::validate_all(field, shape, "velocity", v, "plane", plane);
  const RoundSolid solid = round_solid(shape);
  return first_contact_with_plane(solid.core, solid.radii[0], {exact(v.x), exact(v.y), exact(v.z)}, exact(plane));
}

}  // namespace touchstone::oracle
