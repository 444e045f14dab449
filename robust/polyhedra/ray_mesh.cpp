// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/ray_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/ray_part.h"
#include "robust/mixed/ray_triangle.h"
#include "robust/prepared/surface.h"

namespace touchstone::robust {
namespace {

/// The first of the faces that were met. Until the end, `face` is a triangle.
class FirstFace {
 public:
  FirstFace(const Ray3d& ray, const Meshd& mesh, const std::vector<Index>& named)
      : ray_(ray), mesh_(mesh), named_(named) {}

  /// Only what the filter of the decision does not know goes on to the other stages at once. stay() bounds t.
  template <class Stay>
  void meet(Index face, const Stay& stay) {
    const Triangle3d triangle = triangle_of_face(mesh_, face);
    const auto relation = Each::decision::filter(ray_, triangle);
    if (relation && *relation == SegmentTriangleRelation::none) return;
    const structures::FaceTree::Stay bounds = stay();
    if (relation && waiting_ < hits_.size()) {
      hits_[waiting_++] = {face, bounds.first};
      least_last_ = std::min(least_last_, bounds.last);
      return;
    }
    if (!bounds.begins()) return;
    if (!relation) {
      const auto known = Each::decision::lattice(ray_, triangle);
      if (known && *known == SegmentTriangleRelation::none) return note(Stage::lattice);
    }
    measure(face, triangle);
  }

  Decided<RayMesh<double>> found() {
    for (std::size_t i = 0; i < waiting_; ++i) {
      const auto [face, first] = hits_[i];
      if (first <= least_last_) measure(face, triangle_of_face(mesh_, face));
      else count(face);  // later than another
    }
    if (!named_.empty()) name_faces();
    return {found_, latest_};
  }

 private:
  using Each = stages::ray_triangle;
  struct Hit {
    Index face;
    float first;
  };

  void measure(Index face, const Triangle3d& triangle) {
    if (const auto found = Each::enclosed(ray_, triangle)) {
      note(Stage::enclosed);
      return add(face, *(*found).t, *(*found).point, FacePart::inside);
    }
    note(Stage::exact);
    const kernel::RayPart part(ray_, triangle);
    if (part.relation() == SegmentTriangleRelation::none) return;
    add(face, part.first_t(), part.first_point(),
        part.inside()      ? FacePart::inside
        : part.at_corner() ? FacePart::vertex
                           : FacePart::edge);
  }

  void count(Index face) {
    ++found_.faces_met;
    if (!named_.empty()) met_.push_back(named_[face]);
  }
  /// A face of up to four corners names no bridge, so that what is inside of a triangle of its cut is inside of it.
  void name_faces() {
    std::sort(met_.begin(), met_.end());
    found_.faces_met = static_cast<Index>(std::unique(met_.begin(), met_.end()) - met_.begin());
    if (!found_.first) return;
    auto& [t, point, face, part] = *found_.first;
    const Triangle3d triangle = triangle_of_face(mesh_, face);
    face = named_[face];
    std::vector<Point3d> corners;
    for (const Index i : mesh_.polygons[face]) corners.push_back(mesh_.vertices[i]);
    if (corners.size() == 3 || part == FacePart::vertex || (part == FacePart::inside && corners.size() == 4)) return;
    note(Stage::exact);
    part = kernel::first_part_in(corners, ray_, triangle);
  }

  void note(Stage stage) {
    if (latest_ < stage) latest_ = stage;
  }
  void add(Index face, double t, const Point3d& point, FacePart part) {
    found_.relation = PassageRelation::hit, count(face);
    if (!found_.first || is_before(face, t)) found_.first = {t, point, face, part};
  }
  /// Rounding keeps the order of different numbers, or makes them equal.
  bool is_before(Index face, double t) {
    const std::int64_t here = kernel::ordered_bits(t), there = kernel::ordered_bits(found_.first->t);
    if (here != there) return here < there;
    note(Stage::exact);
    const kernel::RayPart one(ray_, triangle_of_face(mesh_, face)),
        other(ray_, triangle_of_face(mesh_, found_.first->face));
    return one < other || (face < found_.first->face && !(other < one));
  }

  const Ray3d& ray_;
  const Meshd& mesh_;
  const std::vector<Index>& named_;
  std::vector<Index> met_;  ///< named faces, where any has more than three corners
  RayMesh<double> found_{PassageRelation::none, {}, 0};
  Stage latest_ = Stage::filter;
  std::array<Hit, 16> hits_;
  std::size_t waiting_ = 0;
  float least_last_ = std::numeric_limits<float>::infinity();
};

/// One question asks all faces sooner than it makes a tree.
template <class Wanted>
bool any_along(const structures::FaceTree* tree, const Ray3d& ray, const Meshd& mesh, const Wanted& wanted) {
  return tree != nullptr ? tree->any_along(ray, wanted) : structures::FaceTree::any_of_all(mesh, ray, wanted);
}

Decided<RayMesh<double>> first_of_valid(const Ray3d& ray, const Meshd& mesh, const std::vector<Index>& named,
                                        const structures::FaceTree* tree) {
  const kernel::ControlWord guard;
  FirstFace first(ray, mesh, named);
  any_along(tree, ray, mesh, [&first](Index face, const auto& stay) {
    first.meet(face, stay);
    return false;
  });
  return first.found();
}

bool meets_valid(const Ray3d& ray, const Meshd& mesh, const structures::FaceTree* tree) {
  using Decision = stages::ray_triangle::decision;
  const kernel::ControlWord guard;
  return any_along(tree, ray, mesh, [&](Index face, const auto& stay) {
    const Triangle3d triangle = triangle_of_face(mesh, face);
    if (const auto relation = Decision::filter(ray, triangle)) return *relation != SegmentTriangleRelation::none;
    return stay().begins() && Decision::past_filter(ray, triangle).answer != SegmentTriangleRelation::none;
  });
}
const structures::FaceTree* tree_of(const Surface& surface) { return surface.tree() ? &*surface.tree() : nullptr; }
PassageRelation relation(bool meets) { return meets ? PassageRelation::hit : PassageRelation::none; }

void validate(const Ray3d& ray, const Meshd& mesh) {
  validation::validate_numbers("ray", ray), validation::validate_numbers("mesh", mesh);
  validation::validate("ray", ray), Surface::validate("mesh", mesh);
}

}  // namespace

Decided<RayMesh<double>> stages::ray_mesh::ask(const Ray3d& ray, const Meshd& mesh) {
  validate(ray, mesh);
  return first_of_valid(ray, mesh, Surface::named_of(mesh), nullptr);
}

RayMesh<double> ray_mesh(const Ray3d& ray, const Meshd& mesh) { return stages::ray_mesh::ask(ray, mesh).answer; }

RayMesh<double> ray_mesh(const Ray3d& ray, const Surface& surface) {
  validation::validate_all("ray", ray);
  return first_of_valid(ray, surface.mesh(), surface.named(), tree_of(surface)).answer;
}

PassageRelation ray_mesh_relation(const Ray3d& ray, const Meshd& mesh) {
  validate(ray, mesh);
  return relation(meets_valid(ray, mesh, nullptr));
}

PassageRelation ray_mesh_relation(const Ray3d& ray, const Surface& surface) {
  validation::validate_all("ray", ray);
  return relation(meets_valid(ray, surface.mesh(), tree_of(surface)));
}

}  // namespace touchstone::robust
