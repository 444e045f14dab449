// SPDX-License-Identifier: Apache-2.0
// CGAL's Nef polyhedra are under the GPL: they are asked in tests only.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <atomic>
#include <optional>
#include <vector>

#include "catalogue/rows/polyhedra/polyhedron_polyhedron.h"
#include "proptests/catch.h"
#include "proptests/drawn.h"

// CGAL as second opinion: by Boolean operations on cells of all dimensions, of surfaces that bound a volume.
namespace touchstone::proptests {
namespace {

using Row = catalogue::rows::polyhedron_polyhedron;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
namespace pmp = CGAL::Polygon_mesh_processing;

/// Nothing where the mesh is no such surface.
std::optional<Nef> solid(const Meshd& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> at;
  for (const Point3d& p : mesh.vertices) at.push_back(surface.add_vertex({p.x, p.y, p.z}));
  for (const Face& f : mesh.faces) {
    const auto p = [&](Index i) { return surface.point(at[i]); };
    if (CGAL::collinear(p(f.a), p(f.b), p(f.c))) return std::nullopt;
    if (surface.add_face(at[f.a], at[f.b], at[f.c]) == Surface::null_face()) return std::nullopt;
  }
  for (const auto vertex : at)
    if (surface.is_isolated(vertex)) surface.remove_vertex(vertex);
  surface.collect_garbage();
  if (!CGAL::is_closed(surface) || pmp::does_self_intersect(surface)) return std::nullopt;
  // A Nef polyhedron of a surface has all bounded volumes, those between two shells and those within the inner one.
  std::vector<Surface> parts;
  pmp::split_connected_components(surface, parts);
  Nef between_shells(Nef::EMPTY);
  for (Surface& part : parts) {
    pmp::orient_to_bound_a_volume(part);
    between_shells ^= Nef(part);
  }
  return between_shells.closure();
}

}  // namespace

TEST_CASE("polyhedron_polyhedron: CGAL's Nef polyhedra meet, and their interiors do, where the oracle says so") {
  static std::atomic<int> compared[3];
  const auto complaint = [](const catalogue::Question& question) -> std::string {
    const auto asked = catalogue::unpacked<Row::Question>(question);
    const auto& [a, b] = asked;
    if (a.faces.size() + b.faces.size() > 40) return "";
    try {
      const Contact relation = catalogue::ask_oracle<Row>(asked).answer.relation;
      const auto of_a = solid(a), of_b = solid(b);
      if (!of_a || !of_b) return "";
      const bool disjoint = (*of_a * *of_b).is_empty(), overlap = !(of_a->interior() * of_b->interior()).is_empty();
      ++compared[static_cast<int>(relation)];
      return disjoint == (relation == Contact::disjoint) && overlap == (relation == Contact::overlapping)
                 ? ""
                 : "CGAL finds another relation";
    } catch (const InvalidInput&) {
      return "";
    }
  };
  never(*catalogue::find_operation("polyhedron_polyhedron"), "CGAL's Nef polyhedra", complaint, 1);
  for (const auto& count : compared) CHECK(count > 0);
}

}  // namespace touchstone::proptests
