// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/capsule_obb.h"

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

void validate_capsule_obb(const Capsule3d& capsule, const Obb3d& obb) {
  kernel::validate_with_obb("capsule", capsule, "obb", obb);
}

}  // namespace

Perhaps<Contact> stages::capsule_obb::filter(const Capsule3d& capsule, const Obb3d& obb) {
  using filters::moderate;
  const auto& [u, v, w] = obb.half_axes;
  const auto& [a, b] = capsule.segment;
  const double r = capsule.radius;
  if (kernel::sign_bit(r)) return std::nullopt;  // -0.0, or negative, which validation refuses
  if (!(moderate(capsule.segment) & moderate(r) & moderate(obb))) return std::nullopt;
  if (!filters::independent(u, v, w)) return std::nullopt;  // perhaps not a valid box
  return filters::Differences<4, 3>{{u, v, w, a - b}, a - obb.center}.contact(r);
}

/// No distance is less than the radius 0 of a segment, so that its lack of an interior needs no special case.
Contact stages::capsule_obb::exact(const Capsule3d& capsule, const Obb3d& obb) {
  using namespace kernel;
  const auto& [a, b] = capsule.segment;
  const auto [at, exponent] = integer_points(a, b, Point3d{capsule.radius, 0, 0}, obb.center, in_space(obb.half_axes.u),
                                             in_space(obb.half_axes.v), in_space(obb.half_axes.w));
  return contact(squared_distance({at[0], at[1]}, box_of(at, 3)), at[2].x, true);
}

Decided<Contact> stages::capsule_obb::ask(const Capsule3d& capsule, const Obb3d& obb) {
  return in_turn<capsule_obb, Stage::filter, validate_capsule_obb, Stage::exact>(capsule, obb);
}

Contact capsule_obb(const Capsule3d& capsule, const Obb3d& obb) {
  return stages::capsule_obb::ask(capsule, obb).answer;
}

}  // namespace touchstone::robust
