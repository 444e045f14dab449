// SPDX-License-Identifier: Apache-2.0
// CGAL as peer: its tree of the triangles of a mesh (AABB_tree), by its kernel Epick. Under the GPL with what it
// includes.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <touchstone/program/engine_main.h>
#include <touchstone/robust/polyhedra/point_mesh_distance.h>

#include <cmath>

#include "cgal_meshes.h"
#include "exactly.h"

using namespace touchstone;

/// The predicates are exact by the manual; points and distances are rounded, which the name of the kernel says
/// (inexact constructions). Faces without area are left out, as in cgal_meshes.h.
struct CgalEpickTrees {
  static constexpr const char* name = "CGAL Epick " CGAL_VERSION_STR " (AABB_tree)";
  static constexpr auto boundary = Boundary::closed;

  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  /// Rays are kept as two points: those whose second point is exact are asked.
  std::optional<bool> ray_mesh(const Ray3d& ray, const Meshd& mesh) {
    const auto second = exactly::moved(ray.origin, ray.direction);
    const auto triangles = triangles_of(mesh);
    if (!second || !triangles) return std::nullopt;
    if (triangles->empty()) return false;
    const Tree tree(triangles->begin(), triangles->end());
    return tree.do_intersect(Kernel::Ray_3(point(ray.origin), point(*second)));
  }
  /// The distances from the surface of a solid alone: the tree knows neither inside nor outside, names no part of a
  /// face, and promises no particular one of several nearest points. Those are the ones of the truth.
  std::optional<PointMeshDistance<double>> point_mesh_distance(const Point3d& p, const Meshd& mesh) {
    const auto triangles = triangles_of(mesh);
    if (!triangles) return std::nullopt;
    const Tree tree(triangles->begin(), triangles->end());
    const double square = tree.squared_distance(point(p)), distance = std::sqrt(square);
    auto answer = robust::point_mesh_distance(p, mesh);
    answer.squared_distance = square, answer.distance = distance;
    answer.signed_distance = answer.location == Location::inside ? -distance : distance;
    return answer;
  }

 private:
  static Kernel::Point_3 point(const Point3d& p) { return {p.x, p.y, p.z}; }
  static std::optional<Triangles> triangles_of(const Meshd& mesh) {
    Triangles triangles;
    for (const Face& f : mesh.faces) {
      triangles.emplace_back(point(mesh.vertices[f.a]), point(mesh.vertices[f.b]), point(mesh.vertices[f.c]));
      if (triangles.back().is_degenerate()) return std::nullopt;
    }
    return triangles;
  }
};

TOUCHSTONE_ENGINE_MAIN(CgalEpickTrees)
