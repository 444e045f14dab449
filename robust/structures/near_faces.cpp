// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/near_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "robust/kernel/filters/control_word.h"
#include "robust/structures/box_order.h"
#include "robust/structures/box_tree.h"
#include "robust/structures/pair_tree.h"
#include "robust/structures/sort_and_sweep.h"

namespace touchstone::robust::structures {
namespace {

/// Triangles around a vertex of at most this many are compared only by their boxes. An estimate: the answer does not
/// depend on it.
constexpr std::size_t few_faces = 32;

constexpr Aabb3d all_directions{{-1, -1, -1}, {1, 1, 1}};

/// The displacement from a to b divided by four, so that no difference overflows. The sign of each coordinate is right,
/// and it is off by at most 2^-53 of it, or by 2^-1073 if a quarter is rounded.
std::array<double, 3> quarter_way(const Point3d& a, const Point3d& b) {
  return {0.25 * b.x - 0.25 * a.x, 0.25 * b.y - 0.25 * a.y, 0.25 * b.z - 0.25 * a.z};
}

/// A box around the directions d / max(|d.x|, |d.y|, |d.z|) of all displacements d from v to the edge between a and b.
///
/// On that edge each coordinate of d lies between those of the ends. The divisor N is a convex function: no greater
/// than at one of the ends; and no less than |d[k]| for any k, which is not less than the lesser one of the ends where
/// these have one sign. So d[k] / N lies between the quotients of these bounds, and between -1 and 1. The bounds of N
/// and d[k] have relative errors of at most 2^-53, if N exceeds 2^-900: of 2^-1073, 2^-173 are left. With the
/// quotient's rounding the errors are below 2^-50, and 2^-40 is added.
Aabb3d directions(const Point3d& v, const Point3d& a, const Point3d& b) {
  const auto p = quarter_way(v, a), q = quarter_way(v, b);
  double least = 0, most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    most = std::max({most, std::abs(p[k]), std::abs(q[k])});
    if ((p[k] > 0) == (q[k] > 0)) least = std::max(least, std::min(std::abs(p[k]), std::abs(q[k])));
  }
  if (!(least > 0x1p-900)) return all_directions;
  Aabb3d box = all_directions;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = std::min(p[k], q[k]), high = std::max(p[k], q[k]);
    box.min.*coordinates[k] = std::max(-1.0, low / (low < 0 ? least : most) - 0x1p-40);
    box.max.*coordinates[k] = std::min(1.0, high / (high < 0 ? most : least) + 0x1p-40);
  }
  return box;
}

/// The triangles around a vertex of many triangles.
using Group = std::vector<Index>;

Group without_group(const std::vector<std::optional<Index>>& hubs) {
  Group faces;
  for (Index i = 0; i < hubs.size(); ++i)
    if (!hubs[i]) faces.push_back(i);
  return faces;
}

}  // namespace

void look_at_near_faces(const Meshd& mesh, const std::vector<Aabb3d>& boxes,
                        const std::function<void(Index i, Index j)>& look) {
  std::vector<std::size_t> degrees(mesh.vertices.size());
  for (const Face& f : mesh.faces)
    for (const Index v : {f.a, f.b, f.c}) ++degrees[v];
  std::vector<std::optional<Index>> hubs;  // for each triangle, its vertex with the most triangles, if many
  std::map<Index, Group> groups;
  for (const Face& f : mesh.faces) {
    const auto fewer = [&degrees](Index v, Index w) { return degrees[v] < degrees[w]; };
    const Index hub = std::max({f.a, f.b, f.c}, fewer);
    if (degrees[hub] > few_faces) groups[hub].push_back(static_cast<Index>(hubs.size()));
    hubs.push_back(degrees[hub] > few_faces ? std::optional(hub) : std::nullopt);
  }
  const Group others = without_group(hubs);
  const auto look_at_pairs = [&look](const Group& faces, const std::vector<Aabb3d>& of_faces) {
    for (const auto& [i, j] : unsorted_tree_pairs(of_faces)) look(faces[i], faces[j]);  // faces ascend, so i < j
  };
  std::vector<Aabb3d> of_faces;
  for (const Index i : others) of_faces.push_back(boxes[i]);
  look_at_pairs(others, of_faces);
  for (const auto& [hub, faces] : groups) {
    of_faces.clear();
    {
      const kernel::ControlWord guard;
      for (const Index i : faces) {
        const Face& f = mesh.faces[i];
        const auto& [a, b] = hub == f.a ? std::pair{f.b, f.c} : hub == f.b ? std::pair{f.c, f.a} : std::pair{f.a, f.b};
        of_faces.push_back(directions(mesh.vertices[hub], mesh.vertices[a], mesh.vertices[b]));
      }
    }
    look_at_pairs(faces, of_faces);
    BoxTree tree;
    Aabb3d around_all = boxes[faces.front()];
    for (const Index i : faces) tree.insert(boxes[i]), around_all = around(around_all, boxes[i]);
    for (Index j = 0; j < boxes.size(); ++j) {
      if ((hubs[j] && *hubs[j] <= hub) || !structures::meet(boxes[j], around_all)) continue;
      for (const Index place : tree.in_box(boxes[j])) look(std::min(faces[place], j), std::max(faces[place], j));
    }
  }
}

}  // namespace touchstone::robust::structures
