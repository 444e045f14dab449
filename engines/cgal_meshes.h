// SPDX-License-Identifier: Apache-2.0
#pragma once

// CGAL as peer: triangles and closed surfaces. Its package of polygon meshes is under the GPL: programs over this
// header are for auditing, and nothing else of the project contains it.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/intersections.h>
#include <touchstone/geometry/solids.h>
#include <touchstone/geometry/triangles.h>
#include <touchstone/geometry/volumes.h>

#include <optional>
#include <vector>

namespace touchstone {

/// Sets are closed, no tolerance. Degenerate segments and triangles are left out, since its functions assume that there
/// are none. Surfaces are those that it takes (edges and vertices of one fan each), without degenerate faces, that do
/// not cross or touch themselves; all that is decided by exact predicates.
template <class Kernel>
class CgalMeshes {
 public:
  std::optional<bool> segment_triangle(const Segment3d& s, const Triangle3d& t) {
    if (s.a == s.b || flat(t)) return std::nullopt;
    return CGAL::do_intersect(typename Kernel::Segment_3(point(s.a), point(s.b)), triangle(t));
  }
  std::optional<bool> triangle_triangle(const Triangle3d& first, const Triangle3d& second) {
    if (flat(first) || flat(second)) return std::nullopt;
    return CGAL::do_intersect(triangle(first), triangle(second));
  }

  std::optional<Location> point_in_polyhedron(const Meshd& mesh, const Point3d& p) {
    const auto surface = surface_of(mesh);
    if (!surface) return std::nullopt;
    switch (CGAL::Side_of_triangle_mesh<Surface, Kernel>(*surface)(point(p))) {
      case CGAL::ON_BOUNDED_SIDE: return Location::inside;
      case CGAL::ON_BOUNDARY: return Location::boundary;
      default: return Location::outside;
    }
  }
  /// Of solids, by its parameter do_overlap_test_of_bounded_sides.
  std::optional<bool> polyhedron_polyhedron(const Meshd& a, const Meshd& b) {
    const auto first = surface_of(a), second = surface_of(b);
    if (!first || !second) return std::nullopt;
    namespace parameters = CGAL::parameters;
    return CGAL::Polygon_mesh_processing::do_intersect(*first, *second,
                                                       parameters::do_overlap_test_of_bounded_sides(true),
                                                       parameters::do_overlap_test_of_bounded_sides(true));
  }

 private:
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<typename Kernel::Point_3>;

  static typename Kernel::Point_3 point(const Point3d& p) { return {p.x, p.y, p.z}; }
  static typename Kernel::Triangle_3 triangle(const Triangle3d& t) { return {point(t.a), point(t.b), point(t.c)}; }

  template <class K>
  using SurfaceOver = CGAL::Surface_mesh<typename K::Point_3>;

  static bool flat(const Triangle3d& t) {
    const auto exact = [](const Point3d& p) { return Exact::Point_3(p.x, p.y, p.z); };
    return CGAL::collinear(exact(t.a), exact(t.b), exact(t.c));
  }

  template <class K>
  static std::optional<SurfaceOver<K>> made_over(const Meshd& mesh) {
    SurfaceOver<K> surface;
    std::vector<typename SurfaceOver<K>::Vertex_index> at;
    for (const Point3d& p : mesh.vertices) at.push_back(surface.add_vertex(typename K::Point_3(p.x, p.y, p.z)));
    for (const Face& f : mesh.faces)
      if (surface.add_face(at[f.a], at[f.b], at[f.c]) == SurfaceOver<K>::null_face()) return std::nullopt;
    for (const auto vertex : at)
      if (surface.is_isolated(vertex)) surface.remove_vertex(vertex);
    if (!CGAL::is_closed(surface)) return std::nullopt;
    return surface;
  }
  static std::optional<Surface> surface_of(const Meshd& mesh) {
    const auto corner = [&mesh](Index i) { return mesh.vertices[i]; };
    for (const Face& f : mesh.faces)
      if (flat({corner(f.a), corner(f.b), corner(f.c)})) return std::nullopt;
    const auto exact = made_over<Exact>(mesh);
    if (!exact || CGAL::Polygon_mesh_processing::does_self_intersect(*exact)) return std::nullopt;
    return made_over<Kernel>(mesh);
  }
};

}  // namespace touchstone
