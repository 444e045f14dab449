// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/half_space.h"

#include <utility>
#include <vector>

namespace touchstone::oracle {

std::size_t lowest_of(const Hull& points, const Plane<Rational>& plane) {
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (height_over(plane, points[i]) < height_over(plane, points[lowest])) lowest = i;
  return lowest;
}

Truth<Contact> contact_with_half_space(const Hull& core, const Rational& radius, const Plane<Rational>& plane) {
  const std::size_t lowest = lowest_of(core, plane);
  const Point3<Rational> center = core[lowest];
  const Vector3<Rational> n = plane.normal;
  const Rational height = height_over(plane, center), square = dot(n, n);
  // The nearest point is center - steps N.
  const Rational steps = sgn(height) > 0 ? Rational(height / square) : Rational(0);
  const Rational depth(radius * radius - steps * steps * square);
  const Contact contact = sgn(depth) < 0   ? Contact::disjoint
                          : sgn(depth) > 0 ? Contact::overlapping
                                           : Contact::touching;
  return {contact, Rational(abs(depth)), [=, count = core.size()]() -> Certificate {
            // Where they overlap, and the center is not behind the plane, a part t of N farther: the squared distance
            // grows by 2 t E + t^2 N . N, which is less than the depth for t = depth / (depth + 2 E + N . N) < 1.
            const bool farther = contact == Contact::overlapping && sgn(height) >= 0;
            const Rational t = farther ? Rational(depth / (depth + 2 * height + square)) : Rational(0);
            const auto [x, y, z] = center + Rational(-steps - t) * n;
            const char* kinds[] = {"nearest_point", "tangent", "common_interior_point"};
            Certificate found{kinds[static_cast<int>(contact)], {{"point", {x, y, z}}}};
            if (count == 1) return found;
            std::vector<Rational> weights(count);
            weights[lowest] = 1;
            found.facts.emplace_back("weights", std::move(weights));
            return found;
          }};
}

}  // namespace touchstone::oracle
