// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_convex_polyhedron.h"

#include <array>
#include <vector>

#include "geometry/validation.h"
#include "robust/batch/isa/run.h"
#include "robust/kernel/convex_mesh.h"
#include "robust/kernel/face_side.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"

namespace touchstone::robust::batch {
namespace {

/// Of the numbers of a face that isa/beside.h reads those of its plane: a corner, the normal, and the sums of the
/// magnitudes of its terms, 2^-1000 too large. The normal is the one that points outwards: `outside` is the side of the
/// face that is outside, 1 or -1.
std::array<double, 9> plane_numbers(const Point3d& a, const Point3d& b, const Point3d& c, double outside) {
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

/// All of them: the others are the other corners, counter-clockwise as seen from outside.
void add_face(const Meshd& mesh, const Face& face, int outside, std::vector<double>& numbers) {
  const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
  for (const double number : plane_numbers(a, b, c, outside)) numbers.push_back(number);
  for (const Point3d* corner : {outside > 0 ? &b : &c, outside > 0 ? &c : &b})
    for (const double number : {corner->x, corner->y, corner->z}) numbers.push_back(number);
}

}  // namespace

/// The mesh is validated once, and fifteen numbers for each face are kept until the call ends.
void point_in_convex_polyhedron(const Meshd& mesh, const Points3& points, std::size_t count, std::uint8_t* answers,
                                Instructions at_most) {
  if (count == 0) return;
  validation::validate_numbers("mesh", mesh);
  Stage latest = Stage::filter;
  const int outside = kernel::validate_convex("mesh", mesh, latest);
  std::vector<double> faces;
  faces.reserve(15 * mesh.faces.size());
  for (const Face& face : mesh.faces) add_face(mesh, face, outside, faces);
  const auto decide = [&](const Point3d& point) {
    validation::validate("point", point);
    return stages::point_in_convex_polyhedron::of_valid(mesh, point, outside).answer;
  };
  isa::run(isa::Which{&isa::Filters::point_in_convex_solid}, isa::Shared{faces.data(), mesh.faces.size()}, at_most,
           decide, decide, count, answers, points);
}

}  // namespace touchstone::robust::batch
