// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/polyhedron_polyhedron.h"

#include <algorithm>
#include <vector>

#include "geometry/validation.h"
#include "robust/kernel/closed_mesh.h"
#include "robust/kernel/common_interior.h"
#include "robust/kernel/space_box.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/polyhedra/triangle_triangle.h"

namespace touchstone::robust {
namespace {

using kernel::SpaceBox;

/// A vertex of the mesh lies in the interior of the solid. Vertices that no face names do not count.
bool any_vertex_inside(const Meshd& mesh, const Meshd& solid, Stage& latest) {
  const SpaceBox box = SpaceBox::around(solid);
  std::vector<bool> asked(mesh.vertices.size());
  for (const Face& face : mesh.faces) {
    for (const Index i : {face.a, face.b, face.c}) {
      if (asked[i]) continue;
      asked[i] = true;
      const Point3d& p = mesh.vertices[i];
      if (!box.meets(SpaceBox::around(p))) continue;
      if (stages::point_in_polyhedron::of_valid(solid, p).noting(latest) == Location::inside) return true;
    }
  }
  return false;
}

Triangle3d triangle(const Meshd& mesh, const Face& f) {
  return {mesh.vertices[f.a], mesh.vertices[f.b], mesh.vertices[f.c]};
}

bool any_faces_meet(const Meshd& a, const Meshd& b, Stage& latest) {
  const SpaceBox box = SpaceBox::around(b);
  for (const Face& f : a.faces) {
    const SpaceBox around = SpaceBox::around(a, f);
    if (!around.meets(box)) continue;
    for (const Face& g : b.faces) {
      if (!around.meets(SpaceBox::around(b, g))) continue;
      const auto common = stages::triangle_triangle::ask(triangle(a, f), triangle(b, g)).noting(latest);
      if (common != TriangleTriangleRelation::none) return true;
    }
  }
  return false;
}

}  // namespace

Decided<PolyhedronPolyhedron> stages::polyhedron_polyhedron::ask(const Meshd& a, const Meshd& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  kernel::validate_closed("a", a), kernel::validate_closed("b", b);
  Stage latest = Stage::filter;
  if (!SpaceBox::around(a).meets(SpaceBox::around(b)))
    return {{Contact::disjoint, PolyhedraStep::bounding_volumes}, latest};
  const bool inside = any_vertex_inside(a, b, latest) || any_vertex_inside(b, a, latest);
  const PolyhedraStep step = inside ? PolyhedraStep::vertex_inside : PolyhedraStep::edge_against_face;
  if (!inside && !any_faces_meet(a, b, latest)) return {{Contact::disjoint, step}, latest};
  const Contact contact = kernel::have_common_interior(a, b) ? Contact::overlapping : Contact::touching;
  return {{contact, step}, Stage::exact};
}

PolyhedronPolyhedron polyhedron_polyhedron(const Meshd& a, const Meshd& b) {
  return stages::polyhedron_polyhedron::ask(a, b).answer;
}

}  // namespace touchstone::robust
