// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/capsule_aabb.h"

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_capsule_aabb(const Capsule3d& capsule, const Aabb3d& aabb) {
  if (kernel::valid(capsule) && kernel::valid(aabb)) return;
  validation::validate_all("capsule", capsule, "aabb", aabb);
}

}  // namespace

Perhaps<Contact> stages::capsule_aabb::filter(const Capsule3d& capsule, const Aabb3d& aabb) {
  using filters::moderate;
  const auto& [a, b] = capsule.segment;
  const double r = capsule.radius;
  if (kernel::sign_bit(r)) return std::nullopt;  // -0.0, or negative, which validation refuses
  if (!(moderate(capsule.segment) & moderate(r) & moderate(aabb.min) & moderate(aabb.max))) return std::nullopt;
  const Vector3d size = aabb.max - aabb.min;
  if (!((size.x >= 0) & (size.y >= 0) & (size.z >= 0))) return std::nullopt;  // to be refused
  const filters::Differences<4, 0> differences{{{{size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}, a - b}}, a - aabb.min};
  const Perhaps<Contact> contact = differences.contact(r);
  const bool interior = size.x * size.y * size.z > 0;
  return interior || !contact || *contact == Contact::disjoint ? contact : Perhaps<Contact>(Contact::touching);
}

Contact stages::capsule_aabb::exact(const Capsule3d& capsule, const Aabb3d& aabb) {
  using namespace kernel;
  const auto& [a, b] = capsule.segment;
  const auto [at, exponent] = integer_points(a, b, Point3d{capsule.radius, 0, 0}, aabb.min, aabb.max);
  const bool interiors = at[3].x < at[4].x && at[3].y < at[4].y && at[3].z < at[4].z;
  return contact(squared_distance({doubled(at[0]), doubled(at[1])}, doubled_box(at[3], at[4])), 2 * at[2].x, interiors);
}

Decided<Contact> stages::capsule_aabb::ask(const Capsule3d& capsule, const Aabb3d& aabb) {
  return in_turn<capsule_aabb, Stage::filter, validate_capsule_aabb, Stage::exact>(capsule, aabb);
}

Contact capsule_aabb(const Capsule3d& capsule, const Aabb3d& aabb) {
  return stages::capsule_aabb::ask(capsule, aabb).answer;
}

}  // namespace touchstone::robust
