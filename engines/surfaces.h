// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <touchstone/geometry/solids.h>
#include <touchstone/robust/polyhedra/polyhedron_polyhedron.h>
#include <touchstone/robust/polyhedra/triangle_triangle.h>

#include <optional>

/// Solids for engines whose meshes are surfaces.
namespace touchstone::surfaces {

template <class Real>
Point3d in_double(const Point3<Real>& p) {
  return {p.x, p.y, p.z};
}
template <class Real>
Meshd in_double(const Mesh<Real>& mesh) {
  Meshd made;
  for (const Point3<Real>& p : mesh.vertices) made.vertices.push_back(in_double(p));
  made.faces = mesh.faces;
  return made;
}
inline Triangle3d triangle(const Meshd& mesh, const Face& face) {
  return {mesh.vertices[face.a], mesh.vertices[face.b], mesh.vertices[face.c]};
}

/// Whether two surfaces have a point in common, exactly.
inline bool meet(const Meshd& a, const Meshd& b) {
  for (const Face& face : a.faces) {
    for (const Face& other : b.faces)
      if (robust::triangle_triangle(triangle(a, face), triangle(b, other)) != TriangleTriangleRelation::none)
        return true;
  }
  return false;
}

/// Whether the question about the solids is one about their surfaces: it is not where one lies within the other and
/// does not reach its surface.
template <class Real>
bool decide(const Mesh<Real>& a, const Mesh<Real>& b) {
  const Meshd p = in_double(a), q = in_double(b);
  return robust::polyhedron_polyhedron(p, q).relation == Contact::disjoint || meet(p, q);
}

}  // namespace touchstone::surfaces
