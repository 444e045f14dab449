// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/polyhedron_polyhedron.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/filters/space_box.h"
#include "robust/kernel/machine/parallel.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/closed_mesh.h"
#include "robust/kernel/solids/common_interior.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/polyhedra/triangle_triangle.h"
#include "robust/prepared/solid.h"
#include "robust/structures/face_tree.h"

namespace touchstone::robust {
namespace {

using kernel::SpaceBox;

/// True if a vertex of the mesh lies in the interior of the solid. Vertices that no face uses do not count.
bool any_vertex_inside(const Meshd& mesh, const Meshd& solid, Stage& latest) {
  const SpaceBox box = SpaceBox::around(solid);
  std::vector<bool> asked(mesh.vertices.size());
  for (const Face& face : mesh.faces) {
    for (const Index i : {face.a, face.b, face.c}) {
      if (asked[i]) continue;
      asked[i] = true;
      const Point3d& p = mesh.vertices[i];
      if (!box.meets(SpaceBox::around(p))) continue;
      if (stages::point_in_polyhedron::of_valid(solid, p).noting(latest) == Location::inside) return true;
    }
  }
  return false;
}

Triangle3d triangle(const Meshd& mesh, const Face& f) {
  return {mesh.vertices[f.a], mesh.vertices[f.b], mesh.vertices[f.c]};
}

bool any_faces_meet(const Meshd& a, const Meshd& b, Stage& latest) {
  const SpaceBox box = SpaceBox::around(b);
  for (const Face& f : a.faces) {
    const SpaceBox around = SpaceBox::around(a, f);
    if (!around.meets(box)) continue;
    for (const Face& g : b.faces) {
      if (!around.meets(SpaceBox::around(b, g))) continue;
      const auto common = stages::triangle_triangle::ask(triangle(a, f), triangle(b, g)).noting(latest);
      if (common != TriangleTriangleRelation::none) return true;
    }
  }
  return false;
}

/// Returns the faces that may meet a box: those whose corners are not all beyond one of its sides.
std::vector<Index> faces_near(const Meshd& mesh, const SpaceBox& box) {
  std::vector<std::uint8_t> outside;  // of each vertex, a bit for each side
  outside.reserve(mesh.vertices.size());
  for (const Point3d& p : mesh.vertices) {
    const SpaceBox at = SpaceBox::around(p);
    unsigned sides = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sides |= static_cast<unsigned>(at.low[axis] < box.low[axis]) << (2 * axis);
      sides |= static_cast<unsigned>(at.low[axis] > box.high[axis]) << (2 * axis + 1);
    }
    outside.push_back(static_cast<std::uint8_t>(sides));
  }
  std::vector<Index> near;
  for (Index i = 0; i < mesh.faces.size(); ++i) {
    const Face& f = mesh.faces[i];
    if ((outside[f.a] & outside[f.b] & outside[f.c]) == 0) near.push_back(i);
  }
  return near;
}

/// A mesh that is searched by a tree: its own, of one that is prepared, or one that is made when a question is worth
/// it.
class Searched {
 public:
  Searched(const Meshd& of, const SpaceBox& around) : mesh(of), box(around) {}
  explicit Searched(const Solid& solid) : mesh(solid.mesh()), box(solid.box()), prepared_(&solid.tree()) {}

  bool prepared() const { return prepared_ != nullptr; }
  const structures::FaceTree& tree() const {
    if (prepared()) return *prepared_;
    if (!tree_) tree_.emplace(mesh);
    return *tree_;
  }
  Decided<Location> locate(const Point3d& p) const {
    SpaceBox ray = SpaceBox::around(p);
    if (!box.meets(ray)) return {Location::outside, Stage::filter};
    ray.high[0] = box.high[0];
    const bool in_tree = prepared() || tree_ || ++located_ > few_points;
    return in_tree ? stages::point_in_polyhedron::of_tree(mesh, tree(), p)
                   : stages::point_in_polyhedron::of_faces(mesh, faces_near(mesh, ray), p);
  }

  const Meshd& mesh;
  const SpaceBox box;

 private:
  static constexpr int few_points = 8;  ///< for which every face is tested
  const structures::FaceTree* prepared_ = nullptr;
  mutable std::optional<structures::FaceTree> tree_;
  mutable int located_ = 0;
};

/// Estimates a slab across the middle of the common box, as thick as a 128th of its longest side.
SpaceBox slab_of_both(const SpaceBox& a, const SpaceBox& b) {
  const kernel::ControlWord guard;
  SpaceBox slab = a;
  std::size_t longest = 0;
  double most = -1, middle = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    slab.low[axis] = std::max(a.low[axis], b.low[axis]), slab.high[axis] = std::min(a.high[axis], b.high[axis]);
    const double low = kernel::of_ordered_bits(slab.low[axis]) / 2, high = kernel::of_ordered_bits(slab.high[axis]) / 2;
    if (high - low > most) longest = axis, most = high - low, middle = high + low;
  }
  slab.low[longest] = kernel::ordered_bits(middle - most / 128);
  slab.high[longest] = kernel::ordered_bits(middle + most / 128);
  return slab;
}

/// The first vertex of each part whose faces share vertices.
std::vector<Index> one_of_each_part(const Meshd& mesh) {
  std::vector<Index> up(mesh.vertices.size());
  std::iota(up.begin(), up.end(), Index{0});
  const auto root = [&up](Index v) {
    while (up[v] != v) v = up[v] = up[up[v]];
    return v;
  };
  for (const Face& f : mesh.faces) {
    for (const Index v : {f.b, f.c}) {
      const Index p = root(f.a), q = root(v);
      up[std::max(p, q)] = std::min(p, q);
    }
  }
  std::vector<Index> found;
  std::vector<bool> seen(mesh.vertices.size());
  for (const Face& f : mesh.faces) {
    const Index p = root(f.a);
    if (!seen[p]) seen[p] = true, found.push_back(p);
  }
  return found;
}

std::optional<Index> vertex_inside(const Meshd& mesh, const std::vector<Index>& vertices, const Searched& solid,
                                   Stage& latest) {
  for (const Index v : vertices)
    if (solid.locate(mesh.vertices[v]).noting(latest) == Location::inside) return v;
  return std::nullopt;
}

std::vector<Index> named(const Meshd& mesh) {
  std::vector<bool> seen(mesh.vertices.size());
  std::vector<Index> found;
  for (const Face& f : mesh.faces) {
    for (const Index v : {f.a, f.b, f.c})
      if (!seen[v]) seen[v] = true, found.push_back(v);
  }
  return found;
}

/// True if a point just off the face is inside of both. Tries points on both sides, near the middle and near each
/// corner, at several distances. Their rounding does not matter: each is located where it is.
bool common_interior_near(const Meshd& mesh, const Face& f, const Searched& a, const Searched& b) {
  const auto& [p, q, r] = triangle(mesh, f);
  const Vector3d normal = cross(q - p, r - p);
  const double size = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  const double root = std::sqrt(size);
  if (!(root > 0)) return false;
  for (const double share : {0.3, 0x1p-6}) {
    for (const auto& [corner, second, third] : {std::array{p, q, r}, {q, r, p}, {r, p, q}}) {
      const Point3d at = corner + (share * (second - corner)) + (share * (third - corner));
      for (const double distance : {0x1p-4, -0x1p-4, 0x1p-10, -0x1p-10, 0x1p-20, -0x1p-20}) {
        const Point3d near = at + ((share * distance * root / size) * normal);
        if (!kernel::valid(near)) continue;
        if (a.locate(near).answer == Location::inside && b.locate(near).answer == Location::inside) return true;
      }
    }
  }
  return false;
}

/// If no faces have a common point, each part of one that shares vertices is inside or outside of the other as any
/// vertex of it is.
Decided<PolyhedronPolyhedron> of_many_faces(const Searched& a, const Searched& b, std::size_t threads) {
  Stage latest = Stage::filter;
  std::array<Index, 2> meeting{};
  std::mutex one_at_a_time;
  const auto meet = [&](Index f, Index g) {
    const auto common =
        stages::triangle_triangle::ask(triangle(a.mesh, a.mesh.faces[f]), triangle(b.mesh, b.mesh.faces[g]));
    const bool met = common.answer != TriangleTriangleRelation::none;
    if (!met && common.stage == Stage::filter) return false;
    const std::lock_guard lock(one_at_a_time);
    common.noting(latest);
    if (met) meeting = {f, g};
    return met;
  };
  const auto of_both = [threads](const auto& of_a, const auto& of_b) {
    in_parallel(threads, 2, [&](std::size_t i) { i == 0 ? of_a() : of_b(); });
  };
  // Surfaces that cross mostly do so in a slab of few faces, which is found before trees are made.
  const auto meet_in_slab = [&] {
    const SpaceBox slab = slab_of_both(a.box, b.box);
    std::vector<Index> in_a, in_b;
    of_both([&] { in_a = faces_near(a.mesh, slab); }, [&] { in_b = faces_near(b.mesh, slab); });
    return !in_a.empty() && !in_b.empty() &&
           structures::FaceTree(a.mesh, in_a).any_pair(structures::FaceTree(b.mesh, in_b), meet, threads);
  };
  const bool prepared = a.prepared() && b.prepared();
  const auto meet_in_trees = [&] {
    if (!prepared) of_both([&] { a.tree(); }, [&] { b.tree(); });
    return a.tree().any_pair(b.tree(), meet, threads);
  };
  const bool met = (!prepared && meet_in_slab()) || meet_in_trees();
  const Searched* within = nullptr;  // has a vertex inside of the other
  std::optional<Index> inside;
  for (const auto& [one, other] : {std::pair{&a, &b}, {&b, &a}}) {
    if (met && !inside) {
      const Face& f = one->mesh.faces[meeting[one == &b]];
      inside = vertex_inside(one->mesh, {f.a, f.b, f.c}, *other, latest);
      if (inside) within = one;
    }
  }
  for (const auto& [one, other] : {std::pair{&a, &b}, {&b, &a}}) {
    if (inside) break;
    inside = vertex_inside(one->mesh, met ? named(one->mesh) : one_of_each_part(one->mesh), *other, latest);
    if (inside) within = one;
  }
  const PolyhedraStep step = inside ? PolyhedraStep::vertex_inside : PolyhedraStep::edge_against_face;
  if (!met && !inside) return {{Contact::disjoint, step}, latest};
  const auto has_inside = [&inside](const Face& f) { return f.a == *inside || f.b == *inside || f.c == *inside; };
  const Face& face = inside ? *std::find_if(within->mesh.faces.begin(), within->mesh.faces.end(), has_inside)
                            : a.mesh.faces[meeting[0]];
  const bool common = common_interior_near(inside ? within->mesh : a.mesh, face, a, b) ||
                      (met && common_interior_near(b.mesh, b.mesh.faces[meeting[1]], a, b)) ||
                      kernel::have_common_interior(a.mesh, b.mesh);
  return {{common ? Contact::overlapping : Contact::touching, step}, Stage::exact};
}

/// The number of faces from which trees are worth building.
constexpr std::size_t many_faces = 1024;

}  // namespace

Decided<PolyhedronPolyhedron> stages::polyhedron_polyhedron::ask(const Meshd& a, const Meshd& b,
                                                                 std::size_t threads) {
  if (threads == 0) threads = threads_of_machine();
  if (a.faces.size() + b.faces.size() < many_faces) threads = 1;
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  in_parallel(threads, 2, [&](std::size_t i) { kernel::validate_closed(i == 0 ? "a" : "b", i == 0 ? a : b); });
  Stage latest = Stage::filter;
  const SpaceBox box_of_a = SpaceBox::around(a), box_of_b = SpaceBox::around(b);
  if (!box_of_a.meets(box_of_b)) return {{Contact::disjoint, PolyhedraStep::bounding_volumes}, latest};
  if (a.faces.size() + b.faces.size() >= many_faces) return of_many_faces({a, box_of_a}, {b, box_of_b}, threads);
  const bool inside = any_vertex_inside(a, b, latest) || any_vertex_inside(b, a, latest);
  const PolyhedraStep step = inside ? PolyhedraStep::vertex_inside : PolyhedraStep::edge_against_face;
  if (!inside && !any_faces_meet(a, b, latest)) return {{Contact::disjoint, step}, latest};
  const Contact contact = kernel::have_common_interior(a, b) ? Contact::overlapping : Contact::touching;
  return {{contact, step}, Stage::exact};
}

PolyhedronPolyhedron polyhedron_polyhedron(const Solid& a, const Solid& b, std::size_t threads) {
  if (!a.box().meets(b.box())) return {Contact::disjoint, PolyhedraStep::bounding_volumes};
  return of_many_faces(Searched(a), Searched(b), threads == 0 ? threads_of_machine() : threads).answer;
}
PolyhedronPolyhedron polyhedron_polyhedron(const Solid& a, const Solid& b) { return polyhedron_polyhedron(a, b, 1); }

PolyhedronPolyhedron polyhedron_polyhedron(const Meshd& a, const Meshd& b, std::size_t threads) {
  return stages::polyhedron_polyhedron::ask(a, b, threads).answer;
}
PolyhedronPolyhedron polyhedron_polyhedron(const Meshd& a, const Meshd& b) { return polyhedron_polyhedron(a, b, 1); }

}  // namespace touchstone::robust
