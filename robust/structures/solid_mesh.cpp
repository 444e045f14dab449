// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/solid_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "robust/kernel/integers/int192.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/shapes/points_in_space.h"
#include "robust/structures/box_order.h"

namespace touchstone::robust::structures {
namespace {

/// The sign of the volume by coordinates of 30 binary digits, in integers; nullopt if these do not tell.
///
/// Coordinates relative to a vertex, in a unit that makes them at most M = 2^30 in size, are cut off to integers. In
/// the lattice's unit, either end of a difference is off by less than 1. If the unit is not the lattice's, it is at
/// least twice as large, and cutting off to it adds less than 1. So coordinates are off by less than 2, and a
/// determinant, of six products of three of them, by less than 6 ((M + 2)^3 - M^3) < 37 M^2. It is at most 6 M^3, and
/// the sum for less than 2^30 faces is below 2^123.
std::optional<VolumeSign> sign_of_rounded_volume(const Meshd& mesh) {
  if (mesh.faces.size() >= std::size_t{1} << 30) return std::nullopt;
  std::vector<Point3<std::int64_t>> at = kernel::cut_to_lattice(mesh.vertices);
  const Point3<std::int64_t> origin = at[mesh.faces[0].a];
  std::uint64_t digits = 0;
  for (auto& p : at) {
    p = {p.x - origin.x, p.y - origin.y, p.z - origin.z};
    for (const std::int64_t x : {p.x, p.y, p.z}) digits |= kernel::magnitude_of(x);
  }
  const int shift = std::max(0, static_cast<int>(std::bit_width(digits)) - 30);
  for (auto& p : at) p = {p.x >> shift, p.y >> shift, p.z >> shift};
  kernel::Int128 sum = 0;
  for (const Face& f : mesh.faces) {
    const auto &a = at[f.a], &b = at[f.b], &c = at[f.c];
    sum += kernel::Int128{b.y * c.z - b.z * c.y} * a.x + kernel::Int128{b.z * c.x - b.x * c.z} * a.y +
           kernel::Int128{b.x * c.y - b.y * c.x} * a.z;
  }
  const kernel::Int128 error = (kernel::Int128{37} << 60) * static_cast<std::int64_t>(mesh.faces.size());
  if (sum > error) return VolumeSign::positive;
  return sum < -error ? std::optional(VolumeSign::negative) : std::nullopt;
}

/// Some vertices, and the least box around them.
struct BoxedVertices {
  std::vector<Point3d> vertices;
  Aabb3d box;
};

std::vector<BoxedVertices> groups_of(const std::vector<Point3d>& vertices, const std::vector<bool>& used) {
  constexpr std::size_t most = 128;
  std::vector<BoxedVertices> groups;
  const auto add = [&groups](const Point3d& p) {
    if (groups.empty() || groups.back().vertices.size() == most) groups.push_back({{}, {p, p}});
    groups.back().vertices.push_back(p);
    groups.back().box = structures::around(groups.back().box, Aabb3d{p, p});
  };
  for (Index v = 0; v < vertices.size(); ++v)
    if (used[v]) add(vertices[v]);
  return groups;
}

/// True if the plane has points on both sides. A box has its points on the side on which its corners are.
bool splits(const kernel::FaceSide& plane, const std::vector<BoxedVertices>& groups) {
  bool above = false, below = false;
  for (const BoxedVertices& group : groups) {
    int front_corners = 0, back_corners = 0;
    for (const double x : {group.box.min.x, group.box.max.x}) {
      for (const double y : {group.box.min.y, group.box.max.y}) {
        for (const double z : {group.box.min.z, group.box.max.z}) {
          const int side = plane.surely({x, y, z});
          front_corners += static_cast<int>(side > 0), back_corners += static_cast<int>(side < 0);
        }
      }
    }
    above |= front_corners == 8, below |= back_corners == 8;
    if (front_corners == 8 || back_corners == 8) continue;
    for (const Point3d& p : group.vertices) {
      const int side = plane.of(p).answer;
      above |= side > 0, below |= side < 0;
    }
    if (above && below) return true;
  }
  return above && below;
}

}  // namespace

VolumeSign sign_of_volume(const Meshd& mesh) {
  if (const auto sign = sign_of_rounded_volume(mesh)) return *sign;
  const auto integers = kernel::integers_of(Polygon3d{mesh.vertices}).at;
  mpz_class sum;
  const Point3<mpz_class>& origin = integers[mesh.faces[0].a];
  for (const Face& f : mesh.faces)
    sum += dot(integers[f.a] - origin, cross(integers[f.b] - origin, integers[f.c] - origin));
  return sgn(sum) > 0 ? VolumeSign::positive : sgn(sum) < 0 ? VolumeSign::negative : VolumeSign::zero;
}

bool locally_convex(const Meshd& mesh, const EdgeSides& sides) {
  bool in_front = false, behind = false;
  const auto both_ways = [&] { return in_front && behind; };
  sides.for_each_edge([&](Index, const auto first, const auto) {
    if (both_ways()) return;
    const Face &f = mesh.faces[first->corner / 3], &g = mesh.faces[first[1].corner / 3];
    const Index across = std::array{g.c, g.a, g.b}[first[1].corner % 3];
    const int side = kernel::FaceSide(mesh, f).of(mesh.vertices[across]).answer;
    in_front |= side > 0, behind |= side < 0;
  });
  return !both_ways();
}

std::optional<SplittingFace> first_splitting_face(const Meshd& mesh) {
  std::vector<bool> used(mesh.vertices.size());
  for (const Face& f : mesh.faces) used[f.a] = used[f.b] = used[f.c] = true;
  const std::vector<BoxedVertices> groups = groups_of(mesh.vertices, used);
  for (Index i = 0; i < mesh.faces.size(); ++i) {
    const kernel::FaceSide plane(mesh, mesh.faces[i]);
    if (!splits(plane, groups)) continue;
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
