// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when a convex polyhedron that moves along a straight line first has a common point with one at rest: `hit`
/// with the first t in [0, 1], counted in steps, or `never`.
///
/// a moves, b rests. Touching is a hit, grazing too; polyhedra that meet at the start hit at t = 0; the velocity may be
/// 0. The meshes are closed, and their faces are triangles that run counter-clockwise as seen from outside, or all
/// clockwise. Every call checks that they are closed and convex, and then tests every pair of an edge of each: edges
/// times edges times vertices steps, nearly all by the filter. Right for all finite doubles in every floating-point
/// environment, and t correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite
/// number"; so does every mesh that is not the surface of a convex solid (with the face). Contract:
/// reference/sweeps/swept_convex_polyhedra.h.
FirstContact<double> swept_convex_polyhedra(const Meshd& a, const Meshd& b, const Vector3d& velocity);

class ConvexSolid;  // robust/prepared/solid.h
/// The same without its validation.
FirstContact<double> swept_convex_polyhedra(const ConvexSolid& a, const ConvexSolid& b, const Vector3d& velocity);

namespace stages {

/// The latest stage that one of its decisions needed; a t after the start is always computed by `exact`.
struct swept_convex_polyhedra : Signatures<FirstContact<double>(const Meshd&, const Meshd&, const Vector3d&)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
