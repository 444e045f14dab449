// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "geometry/polyhedra.h"
#include "robust/batch/isa/filters.h"

/// Faces of a mesh that all rows share, as the filters of isa/beside.h and isa/solid.h read them.
namespace touchstone::robust::batch::isa {

/// The number of faces from which a tree of them is asked instead of all of them for many points at a time. As measured
/// with spheres on one processor, before faces were linear functions, a tree is faster from about 330 faces on with
/// AVX-512, from 80 on with two doubles at a time.
inline constexpr std::size_t many_faces = 256;

/// The numbers of a face's plane: a corner, the normal, and the sums of the magnitudes of its terms, 2^-1000 too large.
/// `outside` is the side of the face to which the normal points, 1 or -1.
inline std::array<double, 9> plane_numbers(const Point3d& a, const Point3d& b, const Point3d& c, double outside) {
  const Vector3d v = b - a, w = c - a, normal = cross(v, w);
  const auto size = [](double p, double q) { return __builtin_fabs(p) + __builtin_fabs(q) + 0x1p-1000; };
  return {a.x,
          a.y,
          a.z,
          outside * normal.x,
          outside * normal.y,
          outside * normal.z,
          size(v.y * w.z, v.z * w.y),
          size(v.z * w.x, v.x * w.z),
          size(v.x * w.y, v.y * w.x)};
}

/// Adds those and the other corners, counter-clockwise as seen from the side to which the normal points.
inline void add_face(const Meshd& mesh, const Face& face, int outside, std::vector<double>& numbers) {
  const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
  for (const double number : plane_numbers(a, b, c, outside)) numbers.push_back(number);
  for (const Point3d* corner : {outside > 0 ? &b : &c, outside > 0 ? &c : &b})
    for (const double number : {corner->x, corner->y, corner->z}) numbers.push_back(number);
}

/// Adds those and the least y, the greatest y, the least z, the greatest z and the greatest x.
inline void add_boxed_face(const Meshd& mesh, const Face& face, std::vector<double>& numbers) {
  add_face(mesh, face, 1, numbers);
  const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
  const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
  const auto [low_z, high_z] = std::minmax({a.z, b.z, c.z});
  for (const double number : {low_y, high_y, low_z, high_z, std::max({a.x, b.x, c.x})}) numbers.push_back(number);
}

}  // namespace touchstone::robust::batch::isa
