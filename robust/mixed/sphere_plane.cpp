// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/sphere_plane.h"

#include <cstdint>

#include "robust/kernel/filters/height_filter.h"
#include "robust/kernel/filters/plane_filter.h"
#include "robust/kernel/integers/plane_terms.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// The contact of a ball whose center is in the half-space. Reads the radius as bits: a subnormal may be read as zero.
Contact around_center(double radius) { return validation::zero(radius) ? Contact::touching : Contact::overlapping; }

void validate_sphere_plane(const Sphere3d& sphere, const Plane3d& plane) {
  if (kernel::valid(sphere) && kernel::valid(plane)) return;
  validation::validate_all("sphere", sphere, "plane", plane);
}

}  // namespace

/// A ball at rest meets the thin plane at the start or never: then the side of its center decides.
Perhaps<Contact> stages::sphere_plane::filter(const Sphere3d& sphere, const Plane3d& plane) {
  using filters::Meeting;
  if (kernel::sign_bit(sphere.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
  const Meeting meeting = filters::Heights<double>(sphere, {0, 0, 0}, plane).meeting();
  if (meeting == Meeting::at_start) return Contact::overlapping;
  if (meeting != Meeting::never) return std::nullopt;
  return filters::by_sign(filters::plane(plane, sphere.center), Contact::disjoint, around_center(sphere.radius));
}

/// The sign of E, then that of E^2 - r^2 N . N, both squares over one power of two.
Contact stages::sphere_plane::exact(const Sphere3d& sphere, const Plane3d& plane) {
  using namespace kernel;
  const Scaled<mpz_class> height = exact_sum(height_over(plane, sphere.center));
  if (sgn(height.n) <= 0) return around_center(sphere.radius);
  const Scaled<mpz_class> normal = exact_sum(squared_normal(plane));
  const Term radius = term(sphere.radius);
  const mpz_class r = scaled(radius, 0);
  mpz_class distance = height.n * height.n, reach = normal.n * r * r;
  const int shift = 2 * height.exponent - normal.exponent - 2 * radius.exponent;
  if (shift > 0) distance <<= static_cast<std::uint64_t>(shift);
  else reach <<= static_cast<std::uint64_t>(-shift);
  const int sign = cmp(distance, reach);
  return sign > 0 ? Contact::disjoint : sign < 0 ? Contact::overlapping : Contact::touching;
}

Decided<Contact> stages::sphere_plane::ask(const Sphere3d& sphere, const Plane3d& plane) {
  return in_turn<sphere_plane, Stage::filter, validate_sphere_plane, Stage::exact>(sphere, plane);
}

Contact sphere_plane(const Sphere3d& sphere, const Plane3d& plane) {
  return stages::sphere_plane::ask(sphere, plane).answer;
}

}  // namespace touchstone::robust
