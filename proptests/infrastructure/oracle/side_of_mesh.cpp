// SPDX-License-Identifier: Apache-2.0
// CGAL's Side_of_triangle_mesh is under the GPL: it is asked in tests only.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <atomic>
#include <optional>

#include "catalogue/rows/polyhedra/point_in_polyhedron.h"
#include "proptests/catch.h"
#include "proptests/drawn.h"

// CGAL as second opinion: by a ray and a tree of boxes, of surfaces without a rim, every edge in two faces that turn
// the same way, that do not cross or touch themselves.
namespace touchstone::proptests {
namespace {

using Row = catalogue::rows::point_in_polyhedron;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// Nothing where the mesh is no such surface.
std::optional<Location> by_cgal(const Meshd& mesh, const Point3d& point) {
  Surface surface;
  std::vector<Surface::Vertex_index> at;
  for (const Point3d& p : mesh.vertices) at.push_back(surface.add_vertex({p.x, p.y, p.z}));
  for (const Face& f : mesh.faces) {
    if (surface.add_face(at[f.a], at[f.b], at[f.c]) == Surface::null_face()) return std::nullopt;
  }
  for (const auto vertex : at) {
    if (surface.is_isolated(vertex)) surface.remove_vertex(vertex);
  }
  if (!CGAL::is_closed(surface)) return std::nullopt;
  for (const Face& f : mesh.faces) {
    const auto p = [&](Index i) { return surface.point(at[i]); };
    if (CGAL::collinear(p(f.a), p(f.b), p(f.c))) return std::nullopt;
  }
  if (CGAL::Polygon_mesh_processing::does_self_intersect(surface)) return std::nullopt;
  switch (CGAL::Side_of_triangle_mesh<Surface, Kernel>(surface)({point.x, point.y, point.z})) {
    case CGAL::ON_BOUNDED_SIDE: return Location::inside;
    case CGAL::ON_BOUNDARY: return Location::boundary;
    default: return Location::outside;
  }
}

}  // namespace

TEST_CASE("point_in_polyhedron: CGAL finds points on the same side of every surface that it takes") {
  static std::atomic<int> compared[3];
  const auto complaint = [](const catalogue::Question& question) -> std::string {
    const auto asked = catalogue::unpacked<Row::Question>(question);
    const auto& [mesh, point] = asked;
    try {
      const Location location = catalogue::ask_oracle<Row>(asked).answer;
      const auto found = by_cgal(mesh, point);
      if (!found) return "";
      ++compared[static_cast<int>(location)];
      return *found == location ? "" : "CGAL finds the point elsewhere";
    } catch (const InvalidInput&) {
      return "";
    }
  };
  never(*catalogue::find_operation("point_in_polyhedron"), "CGAL's side of the mesh", complaint, 12);
  for (const auto& count : compared) CHECK(count > 0);
}

}  // namespace touchstone::proptests
