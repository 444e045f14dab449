// SPDX-License-Identifier: Apache-2.0
#pragma once

// CGAL as peer: the questions of the arrays, one at a time.
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/intersections.h>

#include <memory>
#include <variant>
#include <vector>

#include "bench/cgal_peers.h"
#include "bench/peers_of_rays.h"

/// The peers that only bench/arrays has. CGAL defines balls by the square of their radius, which is a different
/// question if the square is rounded, so no peer has balls.
namespace touchstone::bench {

template <class K>
typename K::Iso_rectangle_2 cgal(const Aabb2d& box) {
  return {cgal<K>(box.min), cgal<K>(box.max)};
}
template <class K>
typename K::Iso_cuboid_3 cgal(const Aabb3d& box) {
  return {cgal<K>(box.min), cgal<K>(box.max)};
}
template <class K>
typename K::Triangle_3 cgal(const Triangle3d& t) {
  return {cgal<K>(t.a), cgal<K>(t.b), cgal<K>(t.c)};
}
template <class K>
typename K::Ray_2 cgal(const Ray2d& ray) {
  return {cgal<K>(ray.origin), cgal<K>(ray.direction)};
}
template <class K>
typename K::Ray_3 cgal(const Ray3d& ray) {
  const Vector3d& v = ray.direction;
  return {cgal<K>(ray.origin), typename K::Vector_3(v.x, v.y, v.z)};
}

struct PeerThatMeets {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(const auto& a, const auto& b) {
    return std::tuple(cgal<K>(a), cgal<K>(b));
  }
  static int decide(const auto& a, const auto& b) { return CGAL::do_intersect(a, b); }
};
template <>
struct CgalPeer<catalogue::rows::aabb_aabb> : PeerThatMeets {};
template <>
struct CgalPeer<catalogue::rows::triangle_triangle> : PeerThatMeets {};
/// A ray of CGAL goes through a second point, which Epick rounds: nearly the same question.
template <>
struct CgalPeer<catalogue::rows::ray_aabb> : PeerThatMeets {};

/// Many points and one shape.
template <class Shape>
class CgalBeside;

template <>
class CgalBeside<Polygon2d> {
 public:
  explicit CgalBeside(const Polygon2d& ring) {
    for (const Point2d& p : ring.vertices) ring_.push_back(cgal<Epick>(p));
  }
  int decide(const Epick::Point_2& p) const {
    return static_cast<int>(CGAL::bounded_side_2(ring_.begin(), ring_.end(), p, Epick()));
  }

 private:
  std::vector<Epick::Point_2> ring_;
};

template <>
class CgalBeside<Meshd> {
 public:
  explicit CgalBeside(const Meshd& mesh) {
    for (const Point3d& p : mesh.vertices) surface_.add_vertex(cgal<Epick>(p));
    using At = Surface::Vertex_index;
    for (const Face& face : mesh.faces) surface_.add_face(At(face.a), At(face.b), At(face.c));
    side_ = std::make_unique<Side>(surface_);
  }
  int decide(const Epick::Point_3& p) const { return static_cast<int>((*side_)(p)); }

 private:
  using Surface = CGAL::Surface_mesh<Epick::Point_3>;
  using Side = CGAL::Side_of_triangle_mesh<Surface, Epick>;
  Surface surface_;
  std::unique_ptr<Side> side_;
};

}  // namespace touchstone::bench
