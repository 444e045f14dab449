// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <touchstone/geometry/ray_mesh.h>
#include <touchstone/robust/mixed/ray_triangle.h>
#include <touchstone/robust/polyhedra/ray_mesh.h>

#include "surfaces.h"

/// Answers about rays and meshes for engines that give t and a face.
namespace touchstone::mesh_hits {

/// No engine here says where in its face the point is, or lists all faces: both are those of the truth, and so is the
/// face where its own is another that has the first common point. So whether there is a hit, t, the point, and whether
/// the face is one of those are judged.
template <class Real>
RayMesh<Real> answer(const Ray3<Real>& ray, const Mesh<Real>& mesh, Real t, const Point3<Real>& point, Index face) {
  const auto& [p, v] = ray;
  const Ray3d exact{surfaces::in_double(p), {v.x, v.y, v.z}};
  const Meshd same = surfaces::in_double(mesh);
  const auto truth = robust::ray_mesh(exact, same);
  const auto own = robust::ray_triangle(exact, triangle_of_face(same, face));
  FaceHit<Real> hit{t, point, face, FacePart::inside};
  if (truth.first && own.t && *own.t == truth.first->t) hit.face = truth.first->face, hit.part = truth.first->part;
  return {PassageRelation::hit, hit, truth.faces_met};
}

template <class Real>
RayMesh<Real> none() {
  return {PassageRelation::none, {}, 0};
}

}  // namespace touchstone::mesh_hits
