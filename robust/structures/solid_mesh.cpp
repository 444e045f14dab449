// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/solid_mesh.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/shapes/points_in_space.h"

namespace touchstone::robust::structures {
namespace {

/// An edge of a face, and the corner opposite to it.
struct EdgeOfMesh {
  Index low, high, across;
  const Face* face;
  bool operator<(const EdgeOfMesh& other) const { return std::tie(low, high) < std::tie(other.low, other.high); }
};

}  // namespace

VolumeSign sign_of_volume(const Meshd& mesh) {
  const auto integers = kernel::integers_of(Polygon3d{mesh.vertices}).at;
  mpz_class sum;
  const Point3<mpz_class>& origin = integers[mesh.faces[0].a];
  for (const Face& f : mesh.faces)
    sum += dot(integers[f.a] - origin, cross(integers[f.b] - origin, integers[f.c] - origin));
  return sgn(sum) > 0 ? VolumeSign::positive : sgn(sum) < 0 ? VolumeSign::negative : VolumeSign::zero;
}

bool locally_convex(const Meshd& mesh) {
  std::vector<EdgeOfMesh> sides;
  sides.reserve(3 * mesh.faces.size());
  for (const Face& f : mesh.faces) {
    for (const auto& [from, to, across] : {std::array{f.a, f.b, f.c}, {f.b, f.c, f.a}, {f.c, f.a, f.b}})
      sides.push_back({std::min(from, to), std::max(from, to), across, &f});
  }
  std::sort(sides.begin(), sides.end());
  bool in_front = false, behind = false;
  for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
    const int side = kernel::FaceSide(mesh, *sides[k].face).of(mesh.vertices[sides[k + 1].across]).answer;
    in_front |= side > 0, behind |= side < 0;
    if (in_front && behind) return false;
  }
  return true;
}

std::optional<SplittingFace> first_splitting_face(const Meshd& mesh) {
  std::vector<bool> used(mesh.vertices.size());
  for (const Face& f : mesh.faces) used[f.a] = used[f.b] = used[f.c] = true;
  for (Index i = 0; i < mesh.faces.size(); ++i) {
    const kernel::FaceSide plane(mesh, mesh.faces[i]);
    std::optional<Index> off;
    int side_of_off = 0;
    for (Index v = 0; v < mesh.vertices.size(); ++v) {
      if (!used[v]) continue;
      const int side = plane.of(mesh.vertices[v]).answer;
      if (side == 0) continue;
      if (off && side != side_of_off) return SplittingFace{named_face_of_each(mesh)[i], *off, v};
      if (!off) off = v, side_of_off = side;
    }
  }
  return std::nullopt;
}

}  // namespace touchstone::robust::structures
