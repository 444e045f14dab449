// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/sphere_plane.h"

#include <utility>

#include "oracle/exact/rational_validation.h"
#include "oracle/exact/space.h"

namespace touchstone::oracle {
namespace {

/// The point of the half-space nearest to the center is center - steps N.
struct Nearest {
  Point3<Rational> center;
  Vector3<Rational> normal;
  Rational height, squared_normal, squared_radius, steps;

  Rational squared_distance() const { return Rational(steps * steps * squared_normal); }
  Rational depth() const { return Rational(squared_radius - squared_distance()); }

  /// Where they overlap, and the center is not behind the plane, a part t of the normal farther: the squared distance
  /// grows by 2 t E + t^2 N . N, which is less than the depth for t = depth / (depth + 2 E + N . N) < 1.
  Rational beyond() const {
    if (sgn(depth()) <= 0 || sgn(height) < 0) return Rational(0);
    return Rational(depth() / (depth() + 2 * height + squared_normal));
  }
  Certificate certificate() const {
    const int sign = sgn(depth());
    const Point3<Rational> p = center + Rational(-steps - beyond()) * normal;
    return {sign < 0 ? "nearest_point" : sign == 0 ? "tangent" : "common_interior_point", {{"point", {p.x, p.y, p.z}}}};
  }
};

template <class Number>
Truth<Contact> truth(const Sphere3<Number>& sphere, const Plane<Number>& plane) {
  validation::validate("sphere", sphere), validation::validate("plane", plane);
  const Plane<Rational> exactly = exact(plane);
  const Rational radius = exact(sphere.radius), squared_normal = dot(exactly.normal, exactly.normal);
  const Point3<Rational> center = exact(sphere.center);
  const Rational height = height_over(exactly, center);
  const Rational steps = sgn(height) > 0 ? Rational(height / squared_normal) : Rational(0);
  Nearest nearest{center, exactly.normal, height, squared_normal, Rational(radius * radius), steps};
  const Rational depth = nearest.depth();
  return {sgn(depth) < 0   ? Contact::disjoint
          : sgn(depth) > 0 ? Contact::overlapping
                           : Contact::touching,
          Rational(abs(depth)), [nearest = std::move(nearest)] { return nearest.certificate(); }};
}

}  // namespace

Truth<Contact> sphere_plane(const Sphere3d& sphere, const Plane3d& plane) { return truth(sphere, plane); }

template <Exact Number>
Truth<Contact> sphere_plane(const Sphere3<Number>& sphere, const Plane<Number>& plane) {
  return truth(sphere, plane);
}
template Truth<Contact> sphere_plane(const Sphere3<Rational>&, const Plane<Rational>&);

}  // namespace touchstone::oracle
