// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "reference/mixed/closest_point_on_triangle.h"

namespace touchstone::reference {

/// Decides whether a ball and a closed triangle in space overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula combines two: the nearest point of closest_point_on_triangle, and p.
/// 48-50's comparison of its squared distance from the center with the square of the radius. Equal squares are
/// `touching`.
/// sphere, triangle: any unit of length, the same for both. Shapes are closed. A triangle has no interior:
/// `overlapping` is answered where an interior point of the ball is in the triangle, `touching` where they only meet. A
/// triangle without area is the segment or the point that its corners span. A radius of 0 (or -0) is valid: such a ball
/// is a point, which has no interior, and the truth is `touching` at most. NaN or infinity: refused by robust and
/// oracle (field "sphere.center[0]", "triangle[0][0]" ..., "finite number"); so is a negative radius ("sphere.radius",
/// "radius >= 0").
///
/// In exact arithmetic the formula is right where closest_point_on_triangle is: a squared distance is not below 0, the
/// square of the radius of a point.
///
/// Rounding (binary64, to nearest, u = 2^-53): where the formula's nearest point is certainly the corner a, by the
/// contract of closest_point_on_triangle, the computed square of its distance is off by (5 + 11u) u S and 2^-1073, S
/// being exact, and that of the radius by u r^2 and 2^-1075. The comparison is exact. So where |S - r^2| > (5 + 11u) u
/// S + u r^2 + 2^-1072 there, the double version answers as exact arithmetic does, unless something overflows. Nothing
/// is promised for other regions. No number is returned.
template <class Real>
Contact sphere_triangle(const Sphere3<Real>& sphere, const Triangle3<Real>& triangle) {
  const Vector3<Real> displacement = nearest_of_triangle<Real>(sphere.center, triangle) - sphere.center;
  const Real distance = dot(displacement, displacement), squared_radius = Real(sphere.radius * sphere.radius);
  return distance > squared_radius   ? Contact::disjoint
         : distance < squared_radius ? Contact::overlapping
                                     : Contact::touching;
}

}  // namespace touchstone::reference
