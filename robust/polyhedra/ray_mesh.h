// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/ray_mesh.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds where a ray first meets the faces of a mesh, closed or not, and how many faces it meets: `none`, or `hit` with
/// t in units of the direction's length, the point, the face with the least index that has it, and whether it lies
/// `inside` that face, on an `edge` or at a `vertex` of it.
///
/// The origin, edges and vertices belong to them, so no ray passes between two faces that share an edge. Each call
/// asks every face; for many rays on one mesh keep a robust::Surface. Right for all finite doubles in every
/// floating-point environment, and every number correctly rounded (infinite if the exact one is beyond the range). NaN
/// and infinities throw InvalidInput, which names the field and "finite number"; so do a direction of length 0
/// ("nonzero direction"), a face that names no vertex, and a face of more than three corners that is no planar polygon.
/// Contract: reference/polyhedra/ray_mesh.h.
RayMesh<double> ray_mesh(const Ray3d& ray, const Meshd& mesh);

class Surface;  // robust/prepared/surface.h
/// The same without the validation of its mesh, by its tree.
RayMesh<double> ray_mesh(const Ray3d& ray, const Surface& surface);

/// The decision alone, which costs less: it stops at any face that the ray meets.
PassageRelation ray_mesh_relation(const Ray3d& ray, const Meshd& mesh);
PassageRelation ray_mesh_relation(const Ray3d& ray, const Surface& surface);

namespace stages {

/// The latest stage that one of its decisions needed.
struct ray_mesh : Signatures<RayMesh<double>(const Ray3d&, const Meshd&)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
