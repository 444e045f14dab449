// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_sphere_mesh.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/center_near_polygon.h"
#include "robust/kernel/solids/polygon_faces.h"
#include "robust/prepared/surface.h"
#include "robust/sweeps/swept_sphere_triangle.h"

namespace touchstone::robust {
namespace {

/// The first of the faces that the ball was moved against.
class FirstFaceOnWay {
 public:
  FirstFaceOnWay(const Sphere3d& sphere, const Vector3d& velocity, const Meshd& mesh)
      : sphere_(sphere), velocity_(velocity), mesh_(mesh) {}

  /// Returns the first t that is known, or 1.
  double meet(Index face) {
    if (gap_ && sgn(gap_->start) == 0 && face > *found_.face) return 0;
    const Triangle3d triangle = triangle_of_face(mesh_, face);
    const auto known = Each::filter_until(sphere_, velocity_, until_, triangle);
    if (known) {
      if ((*known).t) add(face, kernel::gap_of_start);
    } else {
      latest_ = Stage::exact;
      auto gap = kernel::center_near(sphere_, velocity_, triangle).gap_of_contact();
      if (gap) add(face, std::move(*gap));
    }
    return found_.t ? *found_.t : 1;
  }

  Decided<FirstFaceContact<double>> found() const { return {found_, latest_}; }

 private:
  using Each = stages::swept_sphere_triangle;

  void add(Index face, kernel::SquaredGap gap) {
    const double t = gap.least_zero();
    const int order = gap_ ? compared_with_found(t, gap) : -1;
    if (order > 0 || (order == 0 && face > *found_.face)) return;
    found_ = {HitRelation::hit, t, face}, gap_ = std::move(gap);
    until_ = std::clamp(t * (1 + 0x1p-50), 0x1p-30, 1.0);  // not before the contact, which was rounded
  }
  /// Rounding keeps the order of different numbers, or makes them equal.
  int compared_with_found(double t, const kernel::SquaredGap& gap) const {
    const std::int64_t here = kernel::ordered_bits(t), there = kernel::ordered_bits(*found_.t);
    if (here != there) return here < there ? -1 : 1;
    return kernel::compare_least_zeros(gap, *gap_);
  }

  const Sphere3d& sphere_;
  const Vector3d& velocity_;
  const Meshd& mesh_;
  FirstFaceContact<double> found_{HitRelation::never, {}, {}};
  std::optional<kernel::SquaredGap> gap_;  ///< that of the face, if one is met
  double until_ = 1;                       ///< the part of the step in which a face is asked about
  Stage latest_ = Stage::filter;
};

Decided<FirstFaceContact<double>> first_face_on_way(const Sphere3d& sphere, const Vector3d& velocity, const Meshd& mesh,
                                                    const std::optional<structures::FaceTree>& faces) {
  const kernel::ControlWord guard;
  FirstFaceOnWay first(sphere, velocity, mesh);
  if (faces) faces->on_way({sphere.center, velocity}, sphere.radius, [&first](Index face) { return first.meet(face); });
  Decided<FirstFaceContact<double>> found = first.found();
  if (found.answer.face) found.answer.face = named_face_of(mesh, *found.answer.face);
  return found;
}

}  // namespace

Decided<FirstFaceContact<double>> stages::swept_sphere_mesh::ask(const Sphere3d& sphere, const Vector3d& velocity,
                                                                 const Meshd& mesh) {
  validation::validate_all("sphere", sphere, "velocity", velocity, "mesh", mesh);
  kernel::validate_polygons("mesh", mesh);
  return first_face_on_way(sphere, velocity, mesh, Surface::tree_of(mesh));
}

FirstFaceContact<double> swept_sphere_mesh(const Sphere3d& sphere, const Vector3d& velocity, const Meshd& mesh) {
  return stages::swept_sphere_mesh::ask(sphere, velocity, mesh).answer;
}

FirstFaceContact<double> swept_sphere_mesh(const Sphere3d& sphere, const Vector3d& velocity, const Surface& surface) {
  validation::validate_all("sphere", sphere, "velocity", velocity);
  return first_face_on_way(sphere, velocity, surface.mesh(), surface.tree()).answer;
}

}  // namespace touchstone::robust
