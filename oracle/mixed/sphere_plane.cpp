// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/sphere_plane.h"

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Truth<Contact> truth_sphere_plane(const Sphere3<Number>& sphere, const Plane<Number>& plane) {
  validation::validate_numbers("sphere", sphere), validation::validate_numbers("plane", plane);
  validation::validate("sphere", sphere), validation::validate("plane", plane);
  const Plane<Rational> exactly = exact(plane);
  const Point3<Rational> center = exact(sphere.center);
  const Vector3<Rational>& n = exactly.normal;
  const Rational radius = exact(sphere.radius), height = height_over(exactly, center), square = dot(n, n);
  // The nearest point is center - steps N.
  const Rational steps = sgn(height) > 0 ? Rational(height / square) : Rational(0);
  const Rational depth(radius * radius - steps * steps * square);
  const Contact contact = sgn(depth) < 0   ? Contact::disjoint
                          : sgn(depth) > 0 ? Contact::overlapping
                                           : Contact::touching;
  return {contact, Rational(abs(depth)), [=]() -> Certificate {
            // Where they overlap, and the center is not behind the plane, a part t of N farther: the squared distance
            // grows by 2 t E + t^2 N . N, which is less than the depth for t = depth / (depth + 2 E + N . N) < 1.
            const bool farther = contact == Contact::overlapping && sgn(height) >= 0;
            const Rational t = farther ? Rational(depth / (depth + 2 * height + square)) : Rational(0);
            const auto [x, y, z] = center + Rational(-steps - t) * n;
            const char* kinds[] = {"nearest_point", "tangent", "common_interior_point"};
            return {kinds[static_cast<int>(contact)], {{"point", {x, y, z}}}};
          }};
}

}  // namespace

Truth<Contact> sphere_plane(const Sphere3d& sphere, const Plane3d& plane) { return truth_sphere_plane(sphere, plane); }

template <Exact Number>
Truth<Contact> sphere_plane(const Sphere3<Number>& sphere, const Plane<Number>& plane) {
  return truth_sphere_plane(sphere, plane);
}
template Truth<Contact> sphere_plane(const Sphere3<Rational>&, const Plane<Rational>&);

}  // namespace touchstone::oracle
