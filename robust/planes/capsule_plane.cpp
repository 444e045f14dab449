// SPDX-License-Identifier: Apache-2.0
#include "robust/planes/capsule_plane.h"

#include <algorithm>

#include "robust/kernel/shapes/valid.h"
#include "robust/mixed/sphere_plane.h"

namespace touchstone::robust {
namespace {

void validate_capsule_plane(const Capsule3d& capsule, const Plane3d& plane) {
  if (kernel::valid(capsule) && kernel::valid(plane)) return;
  validation::validate_all("capsule", capsule, "plane", plane);
}

}  // namespace

/// No point of a segment is lower than both ends, so a capsule meets a half-space as far as one of the balls around
/// them does. The filter is certain of valid numbers only.
Perhaps<Contact> stages::capsule_plane::filter(const Capsule3d& capsule, const Plane3d& plane) {
  const auto& [segment, radius] = capsule;
  const auto at_a = sphere_plane::filter({segment.a, radius}, plane);
  if (!at_a) return std::nullopt;
  const auto at_b = sphere_plane::filter({segment.b, radius}, plane);
  if (!at_b) return std::nullopt;
  return std::max(*at_a, *at_b);
}

Contact stages::capsule_plane::exact(const Capsule3d& capsule, const Plane3d& plane) {
  const auto& [segment, radius] = capsule;
  return std::max(sphere_plane::exact({segment.a, radius}, plane), sphere_plane::exact({segment.b, radius}, plane));
}

Decided<Contact> stages::capsule_plane::ask(const Capsule3d& capsule, const Plane3d& plane) {
  return in_turn<capsule_plane, Stage::filter, validate_capsule_plane, Stage::exact>(capsule, plane);
}

Contact capsule_plane(const Capsule3d& capsule, const Plane3d& plane) {
  return stages::capsule_plane::ask(capsule, plane).answer;
}

}  // namespace touchstone::robust
