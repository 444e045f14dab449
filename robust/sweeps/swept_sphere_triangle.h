// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when a ball that moves along a straight line first has a common point with a closed triangle in space: `hit`
/// with the first t in [0, 1], counted in steps, or `never`.
///
/// The triangle has two sides; one without area is the segment or the point that its corners span. Touching is a hit; a
/// ball that meets the triangle at the start hits at t = 0; radius 0 is a point, and the velocity may be 0. Right for
/// all finite doubles in every floating-point environment, and t correctly rounded. NaN and infinities throw
/// InvalidInput, which names the field and "finite number"; so does a negative radius ("radius >= 0"). Contract:
/// reference/sweeps/swept_sphere_triangle.h.
FirstContact<double> swept_sphere_triangle(const Sphere3d& sphere, const Vector3d& velocity,
                                           const Triangle3d& triangle);

namespace stages {

/// The filter decides the steps that hit at the start, and those that never do: then there is no number to compute.
struct swept_sphere_triangle : Signatures<decltype(robust::swept_sphere_triangle)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
  /// The same as the filter, of the step as far as t = until, which is at least 2^-30 and at most 1.
  static Perhaps<FirstContact<double>> filter_until(const Sphere3d& sphere, const Vector3d& velocity, double until,
                                                    const Triangle3d& triangle);
};

}  // namespace stages

}  // namespace touchstone::robust
