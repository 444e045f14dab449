// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/capsule_capsule.h"

#include "robust/kernel/enclosed/enclosed_nearest.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_capsule_capsule(const Capsule3d& a, const Capsule3d& b) {
  if (kernel::valid(a) && kernel::valid(b)) return;
  validation::validate_all("a", a, "b", b);
}

bool interiors(const Capsule3d& a, const Capsule3d& b) {
  return !validation::zero(a.radius) && !validation::zero(b.radius);
}

}  // namespace

Perhaps<Contact> stages::capsule_capsule::filter(const Capsule3d& a, const Capsule3d& b) {
  if (kernel::sign_bit(a.radius) || kernel::sign_bit(b.radius)) return std::nullopt;  // -0.0, or to be refused
  return filters::contact(a.segment, a.radius, b.segment, b.radius, interiors(a, b));
}

Perhaps<Contact> stages::capsule_capsule::enclosed(const Capsule3d& a, const Capsule3d& b) {
  return kernel::close_contact(a.segment, a.radius, b.segment, b.radius, interiors(a, b));
}

Contact stages::capsule_capsule::exact(const Capsule3d& a, const Capsule3d& b) {
  using namespace kernel;
  const auto [at, exponent] =
      integer_points(a.segment.a, a.segment.b, b.segment.a, b.segment.b, Point3d{a.radius, b.radius, 0});
  const QuotientPair nearest = nearest_pair({at[0], at[1]}, {at[2], at[3]});
  const auto& [r, s, zero] = at[4];
  return contact(squared_distance(nearest.on_a, nearest.on_b), r + s, sgn(r) != 0 && sgn(s) != 0);
}

Decided<Contact> stages::capsule_capsule::ask(const Capsule3d& a, const Capsule3d& b) {
  return in_turn<capsule_capsule, Stage::filter, validate_capsule_capsule, Stage::enclosed, Stage::exact>(a, b);
}

Contact capsule_capsule(const Capsule3d& a, const Capsule3d& b) { return stages::capsule_capsule::ask(a, b).answer; }

}  // namespace touchstone::robust
