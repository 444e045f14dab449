// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "oracle/exact/numbers/space.h"
#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

/// The index of a point of the least height over a plane; so none of their hull is lower.
std::size_t lowest_of(const Hull& points, const Plane<Rational>& plane);

/// The contact of all that is no farther from the hull of points than a radius, and the half-space behind a plane: with
/// the lowest of these points, and the point of the half-space that is nearest to it, which is itself or the foot of its
/// perpendicular on the plane, and rational. The solids have a common point exactly if both are no farther apart than
/// the radius, and a common interior point exactly if they are nearer.
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

}  // namespace touchstone::oracle
