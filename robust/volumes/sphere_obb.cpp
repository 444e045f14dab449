// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/sphere_obb.h"

#include "geometry/validation.h"
#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

void validate_sphere_obb(const Sphere3d& sphere, const Obb3d& obb) {
  if (!kernel::valid(sphere)) {
    validation::validate_numbers("sphere", sphere), validation::validate_numbers("obb", obb);
    validation::validate("sphere", sphere);
  }
  kernel::validate_obb("obb", obb);
}

}  // namespace

Perhaps<Contact> stages::sphere_obb::filter(const Sphere3d& sphere, const Obb3d& obb) {
  using filters::moderate;
  const auto& [u, v, w] = obb.half_axes;
  const Point3d &p = sphere.center, &c = obb.center;
  const double r = sphere.radius;
  if (kernel::sign_bit(r)) return std::nullopt;  // -0.0, or negative, which validation refuses
  if (!(moderate(p) & moderate(r) & moderate(c) & moderate(u) & moderate(v) & moderate(w))) return std::nullopt;
  if (!filters::independent(u, v, w)) return std::nullopt;  // perhaps not a valid box
  const filters::Differences<3> differences{{u, v, w}, p - c};
  return differences.contact(r);
}

/// No distance is less than the radius 0 of a point, so that its lack of an interior needs no special case.
Contact stages::sphere_obb::exact(const Sphere3d& sphere, const Obb3d& obb) {
  using namespace kernel;
  const auto& [u, v, w] = obb.half_axes;
  const auto [at, exponent] = integer_points(sphere.center, obb.center, Point3d{u.x, u.y, u.z}, Point3d{v.x, v.y, v.z},
                                             Point3d{w.x, w.y, w.z}, Point3d{sphere.radius, 0, 0});
  const IntegerPoint origin{0, 0, 0};
  const QuotientPoint nearest = nearest_in_box(at[0], {at[1], {at[2] - origin, at[3] - origin, at[4] - origin}});
  return contact(squared_distance(nearest, {at[0], 1}), at[5].x, true);
}

Decided<Contact> stages::sphere_obb::ask(const Sphere3d& sphere, const Obb3d& obb) {
  return in_turn<sphere_obb, Stage::filter, validate_sphere_obb, Stage::exact>(sphere, obb);
}

Contact sphere_obb(const Sphere3d& sphere, const Obb3d& obb) { return stages::sphere_obb::ask(sphere, obb).answer; }

}  // namespace touchstone::robust
