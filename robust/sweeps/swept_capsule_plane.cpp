// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_capsule_plane.h"

#include "robust/kernel/filters/decode.h"
#include "robust/kernel/filters/height_filter.h"
#include "robust/kernel/shapes/first_contact.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/planes/point_plane.h"
#include "robust/sweeps/swept_sphere_plane.h"

namespace touchstone::robust {
namespace {

/// The balls around both ends, as far as signs decide.
struct MovingEnds {
  filters::Heights<double> a, b;
  filters::Meeting of_a, of_b;

  MovingEnds(const Capsule3d& capsule, const Vector3d& velocity, const Plane3d& plane)
      : a({capsule.segment.a, capsule.radius}, velocity, plane),
        b({capsule.segment.b, capsule.radius}, velocity, plane),
        of_a(a.meeting()),
        of_b(b.meeting()) {}

  bool certain() const { return of_a != filters::Meeting::unknown && of_b != filters::Meeting::unknown; }
  bool meet(filters::Meeting meeting) const { return of_a == meeting && of_b == meeting; }
  /// If they are certain: a ball meets the plane, or the segment crosses it.
  bool at_start() const {
    using filters::Meeting;
    return of_a == Meeting::at_start || of_b == Meeting::at_start || a.behind() != b.behind();
  }
};

void validate_swept_capsule_plane(const Capsule3d& capsule, const Vector3d& velocity, const Plane3d& plane) {
  if (kernel::valid(capsule) && kernel::valid(velocity) && kernel::valid(plane)) return;
  validation::validate_all("capsule", capsule, "velocity", velocity, "plane", plane);
}

}  // namespace

Perhaps<FirstContact<double>> stages::swept_capsule_plane::filter(const Capsule3d& capsule, const Vector3d& velocity,
                                                                  const Plane3d& plane) {
  if (kernel::sign_bit(capsule.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
  const MovingEnds ends(capsule, velocity, plane);
  if (!ends.certain()) return std::nullopt;  // as it is of numbers that are not finite
  if (ends.at_start()) return kernel::hit(0);
  if (ends.meet(filters::Meeting::never)) return kernel::no_hit;
  return std::nullopt;
}

/// With both ends on one side, no point of the segment is nearer to the plane than both are, as long as none has passed
/// it: the capsule meets the plane when the first of the balls around its ends does. Times keep their order when they
/// are rounded.
Perhaps<FirstContact<double>> stages::swept_capsule_plane::enclosed(const Capsule3d& capsule, const Vector3d& velocity,
                                                                    const Plane3d& plane) {
  const MovingEnds ends(capsule, velocity, plane);
  if (kernel::sign_bit(capsule.radius) || !ends.certain() || ends.at_start()) return std::nullopt;
  FirstContact<double> first = kernel::no_hit;
  const auto moves = [&](const Point3d& end, filters::Meeting meeting) {
    if (meeting == filters::Meeting::never) return true;
    const auto contact = swept_sphere_plane::enclosed({end, capsule.radius}, velocity, plane);
    if (contact) first = kernel::earlier(first, *contact);
    return static_cast<bool>(contact);
  };
  if (!moves(capsule.segment.a, ends.of_a) || !moves(capsule.segment.b, ends.of_b)) return std::nullopt;
  return first;
}

FirstContact<double> stages::swept_capsule_plane::exact(const Capsule3d& capsule, const Vector3d& velocity,
                                                        const Plane3d& plane) {
  const auto& [segment, radius] = capsule;
  using Side = point_plane::decision;
  if (Side::exact(plane, segment.a) != Side::exact(plane, segment.b)) return kernel::hit(0);
  return kernel::earlier(swept_sphere_plane::exact({segment.a, radius}, velocity, plane),
                         swept_sphere_plane::exact({segment.b, radius}, velocity, plane));
}

Decided<FirstContact<double>> stages::swept_capsule_plane::ask(const Capsule3d& capsule, const Vector3d& velocity,
                                                               const Plane3d& plane) {
  return in_turn<swept_capsule_plane, Stage::filter, Stage::enclosed, validate_swept_capsule_plane, Stage::exact>(
      capsule, velocity, plane);
}

FirstContact<double> swept_capsule_plane(const Capsule3d& capsule, const Vector3d& velocity, const Plane3d& plane) {
  return stages::swept_capsule_plane::ask(capsule, velocity, plane).answer;
}

}  // namespace touchstone::robust
