// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_capsule_capsule.h"

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/shapes/center_near_polygon.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_swept_capsule_capsule(const Capsule3d& a, const Capsule3d& b, const Vector3d& velocity) {
  if (kernel::valid(a) && kernel::valid(b) && kernel::valid(velocity)) return;
  validation::validate_all("a", a, "b", b, "velocity", velocity);
}

}  // namespace

/// The segments at the start are two cores; so are what the first sweeps over and the second.
Perhaps<FirstContact<double>> stages::swept_capsule_capsule::filter(const Capsule3d& a, const Capsule3d& b,
                                                                    const Vector3d& velocity) {
  using filters::moderate;
  if (!(moderate(a.segment) & moderate(a.radius) & moderate(b.segment) & moderate(b.radius) & moderate(velocity)))
    return std::nullopt;
  const Vector3d u = a.segment.b - a.segment.a, w = b.segment.b - b.segment.a, way = a.segment.a - b.segment.a;
  const double reach = a.radius + b.radius;
  const Perhaps<Contact> start = filters::Differences<2, 0>{{-1.0 * u, w}, way}.contact(reach);
  if (start && *start == Contact::overlapping) return kernel::hit(0);
  const Perhaps<Contact> step = filters::Differences<3, 0>{{-1.0 * velocity, -1.0 * u, w}, way}.contact(reach);
  if (step && *step == Contact::disjoint) return kernel::no_hit;
  return std::nullopt;
}

/// The first end of a is the center of a ball with both radii; the points of b less the displacements along a are a
/// parallelogram.
FirstContact<double> stages::swept_capsule_capsule::exact(const Capsule3d& a, const Capsule3d& b,
                                                          const Vector3d& velocity) {
  const auto& [p, q] = a.segment;
  const auto& [c, d] = b.segment;
  const auto n = kernel::integers_of(p.x, p.y, p.z, q.x, q.y, q.z, c.x, c.y, c.z, d.x, d.y, d.z, velocity.x, velocity.y,
                                     velocity.z, a.radius, b.radius)
                     .at;
  const auto at = [&n](std::size_t i) { return kernel::vector_at(n, i); };
  const kernel::CenterNearPolygon<4> center({at(0) - at(6), at(0) - at(9), at(3) - at(9), at(3) - at(6)}, at(12),
                                            n[15] + n[16]);
  return center.first_contact();
}

/// The filter takes the square of a negative radius: the capsules are validated first.
Decided<FirstContact<double>> stages::swept_capsule_capsule::ask(const Capsule3d& a, const Capsule3d& b,
                                                                 const Vector3d& velocity) {
  return in_turn<swept_capsule_capsule, validate_swept_capsule_capsule, Stage::filter, Stage::exact>(a, b, velocity);
}

FirstContact<double> swept_capsule_capsule(const Capsule3d& a, const Capsule3d& b, const Vector3d& velocity) {
  return stages::swept_capsule_capsule::ask(a, b, velocity).answer;
}

}  // namespace touchstone::robust
