// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/sphere_capsule.h"

#include "robust/kernel/enclosed/enclosed_nearest.h"
#include "robust/kernel/filters/around_box_filter.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_sphere_capsule(const Sphere3d& sphere, const Capsule3d& capsule) {
  if (kernel::valid(sphere) && kernel::valid(capsule)) return;
  validation::validate_all("sphere", sphere, "capsule", capsule);
}

/// At least the sum of both, in every environment: the sum loses no more than 2^-52 of itself, and if a part is flushed
/// or read as zero less than 2^-1020; the product loses another 2^-52. Not proved by machine.
double at_least_sum(double r, double s) { return (r + s) * (1 + 0x1p-50) + 0x1p-1000; }

bool interiors(const Sphere3d& sphere, const Capsule3d& capsule) {
  return !validation::zero(sphere.radius) && !validation::zero(capsule.radius);
}

}  // namespace

Perhaps<Contact> stages::sphere_capsule::filter(const Sphere3d& sphere, const Capsule3d& capsule) {
  if (kernel::sign_bit(sphere.radius) || kernel::sign_bit(capsule.radius)) return std::nullopt;
  const auto& [a, b] = capsule.segment;
  if (const auto apart = filters::beyond_box(sphere.center, at_least_sum(sphere.radius, capsule.radius), a, b))
    return apart;
  return filters::contact(capsule.segment, capsule.radius, sphere.center, sphere.radius, interiors(sphere, capsule));
}

Perhaps<Contact> stages::sphere_capsule::enclosed(const Sphere3d& sphere, const Capsule3d& capsule) {
  return kernel::close_contact(capsule.segment, capsule.radius, sphere.center, sphere.radius,
                               interiors(sphere, capsule));
}

Contact stages::sphere_capsule::exact(const Sphere3d& sphere, const Capsule3d& capsule) {
  using namespace kernel;
  const auto& [a, b] = capsule.segment;
  const auto [at, exponent] = integer_points(sphere.center, a, b, Point3d{sphere.radius, capsule.radius, 0});
  const QuotientPoint nearest = nearest_on_segment(at[0], {at[1], at[2]});
  const auto& [r, s, zero] = at[3];
  return contact(squared_distance(nearest, {at[0], 1}), r + s, sgn(r) != 0 && sgn(s) != 0);
}

Decided<Contact> stages::sphere_capsule::ask(const Sphere3d& sphere, const Capsule3d& capsule) {
  return in_turn<sphere_capsule, Stage::filter, validate_sphere_capsule, Stage::enclosed, Stage::exact>(sphere,
                                                                                                        capsule);
}

Contact sphere_capsule(const Sphere3d& sphere, const Capsule3d& capsule) {
  return stages::sphere_capsule::ask(sphere, capsule).answer;
}

}  // namespace touchstone::robust
