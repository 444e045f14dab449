// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/sphere_obb.h"

#include "robust/kernel/enclosed/enclosed_in_obb.h"
#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

void validate_sphere_obb(const Sphere3d& sphere, const Obb3d& obb) {
  kernel::validate_with_obb("sphere", sphere, "obb", obb);
}

}  // namespace

Perhaps<Contact> stages::sphere_obb::filter(const Sphere3d& sphere, const Obb3d& obb) {
  using filters::moderate;
  const auto& [u, v, w] = obb.half_axes;
  const double r = sphere.radius;
  if (kernel::sign_bit(r)) return std::nullopt;  // -0.0, or negative, which validation refuses
  if (!(moderate(sphere.center) & moderate(r) & moderate(obb))) return std::nullopt;
  if (!filters::independent(u, v, w)) return std::nullopt;  // perhaps not a valid box
  return filters::Differences<3>{{u, v, w}, sphere.center - obb.center}.contact(r);
}

Perhaps<Contact> stages::sphere_obb::enclosed(const Sphere3d& sphere, const Obb3d& obb) {
  return kernel::close_contact(sphere, obb);
}

/// No distance is less than the radius 0 of a point, so that its lack of an interior needs no special case.
Contact stages::sphere_obb::exact(const Sphere3d& sphere, const Obb3d& obb) {
  using namespace kernel;
  const auto& [u, v, w] = obb.half_axes;
  const auto [at, exponent] = integer_points(sphere.center, Point3d{sphere.radius, 0, 0}, obb.center, u, v, w);
  const QuotientPoint nearest = nearest_in_box(at[0], box_of(at, 2));
  return contact(squared_distance(nearest, {at[0], 1}), at[1].x, true);
}

Decided<Contact> stages::sphere_obb::ask(const Sphere3d& sphere, const Obb3d& obb) {
  return in_turn<sphere_obb, Stage::filter, validate_sphere_obb, Stage::enclosed, Stage::exact>(sphere, obb);
}

Contact sphere_obb(const Sphere3d& sphere, const Obb3d& obb) { return stages::sphere_obb::ask(sphere, obb).answer; }

}  // namespace touchstone::robust
