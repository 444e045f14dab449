// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/ray_mesh.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when a ball that moves along a straight line first has a common point with the faces of a mesh, closed or not:
/// `hit` with the first t in [0, 1], counted in steps, and the least index of the faces that it has one with then, or
/// `never`.
///
/// The mesh is its faces, not a solid within them: a ball inside a closed mesh that is far from all faces moves freely.
/// Faces have two sides; one without area is the segment or the point that its corners span. Touching is a hit; a ball
/// that meets faces at the start hits at t = 0; radius 0 is a point, and the velocity may be 0. Each call sorts the
/// faces into a tree; for many balls and one mesh keep a robust::Surface. Right for all finite doubles in every
/// floating-point environment, and t correctly rounded; the face is the one that is met first without rounding. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so do a negative radius ("radius >= 0"), a
/// face that names no vertex, and a face of more than three corners that is no planar polygon. Contract:
/// reference/sweeps/swept_sphere_mesh.h.
FirstFaceContact<double> swept_sphere_mesh(const Sphere3d& sphere, const Vector3d& velocity, const Meshd& mesh);

class Surface;  // robust/prepared/surface.h
/// The same without the validation of its mesh, by its tree.
FirstFaceContact<double> swept_sphere_mesh(const Sphere3d& sphere, const Vector3d& velocity, const Surface& surface);

namespace stages {

/// The latest stage that one of its decisions needed.
struct swept_sphere_mesh : Signatures<FirstFaceContact<double>(const Sphere3d&, const Vector3d&, const Meshd&)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
