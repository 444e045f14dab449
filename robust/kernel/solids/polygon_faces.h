// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"
#include "robust/kernel/solids/ear_clipping.h"

/// Faces of more than three corners. geometry/polyhedra.h defines which polygons and which triangulations are valid.
namespace touchstone::robust::kernel {

/// 1, 0, -1: p, q, r turn left, are collinear, turn right. Right for all finite doubles.
int sign_of_turn(const Point2d& p, const Point2d& q, const Point2d& r);
int sign_of_turn(const Point2<mpq_class>& p, const Point2<mpq_class>& q, const Point2<mpq_class>& r);

/// True if four points are coplanar.
bool in_one_plane(const Point3d& a, const Point3d& b, const Point3d& c, const Point3d& d);
bool in_one_plane(const Point3<mpq_class>& a, const Point3<mpq_class>& b, const Point3<mpq_class>& c,
                  const Point3<mpq_class>& d);

/// A polygon with coplanar corners, seen along a coordinate axis that leads out of its plane. Vertices are named by
/// their indices in the mesh. The mesh's vertices and the corners must outlive it.
template <class Real>
class ProjectedPolygon {
 public:
  /// Returns nullopt if the corners are not coplanar.
  static std::optional<ProjectedPolygon> of(const std::vector<Point3<Real>>& vertices,
                                            const std::vector<Index>& corners);

  /// Positive to the left, whatever the polygon's orientation.
  int turn_of(Index p, Index q, Index r) const { return sign_of_turn(projected(p), projected(q), projected(r)); }
  bool in_one_position(Index p, Index q) const { return vertices_[p] == vertices_[q]; }

 private:
  using Axis = Real Point3<Real>::*;
  ProjectedPolygon(const std::vector<Point3<Real>>& vertices, Axis u, Axis v) : vertices_(vertices), u_(u), v_(v) {}
  Point2<Real> projected(Index p) const { return {vertices_[p].*u_, vertices_[p].*v_}; }

  const std::vector<Point3<Real>>& vertices_;
  Axis u_, v_;
};

enum class PolygonDefect {
  askew,    ///< its corners are not coplanar
  no_ring,  ///< it encloses no area, crosses itself, touches one of its edges, or has several parts
};

/// A valid triangulation of a polygon with at least three corners, all of them vertices, by ear clipping.
template <class Real>
std::variant<std::vector<Face>, PolygonDefect> cut_polygon(const std::vector<Point3<Real>>& vertices,
                                                           const std::vector<Index>& corners);

/// Refuses a mesh with polygons that are not planar or triangles that do not triangulate them. Its numbers are finite
/// and its indices valid.
void validate_polygons(const std::string& field, const Meshd& mesh);

}  // namespace touchstone::robust::kernel
