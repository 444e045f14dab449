// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/half_space.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "oracle/exact/numbers/parabola.h"

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

namespace {

/// E at the start, its change in a step, r^2 and N . N.
struct Approach {
  Rational height, rise, squared_radius, squared_normal;

  Rational start() const { return Rational(height * height - squared_radius * squared_normal); }
  Rational half() const { return Rational(height * rise); }
  Rational square() const { return Rational(rise * rise); }
};

/// f times a common denominator, which moves no zero.
Parabola parabola_of(const Approach& a) {
  Rational start = a.start(), half = a.half(), square = a.square();
  Integer common(1);
  for (const Rational* coefficient : {&start, &half, &square})
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), coefficient->get_den_mpz_t());
  const auto integer = [&common](const Rational& c) { return Integer(c.get_num() * (common / c.get_den())); };
  return {integer(start), integer(half), integer(square)};
}

}  // namespace

Truth<FirstContact<Surd>> first_contact_with_plane(const Hull& core, const Rational& radius,
                                                   const Vector3<Rational>& velocity, const Plane<Rational>& plane) {
  std::vector<Rational> heights;
  for (const Point3<Rational>& p : core) heights.push_back(height_over(plane, p));
  const auto [least, greatest] = std::minmax_element(heights.begin(), heights.end());
  const Rational low = *least, high = *greatest, none(0), nearest = std::clamp(none, low, high);
  Approach a{nearest, dot(plane.normal, velocity), Rational(radius * radius), dot(plane.normal, plane.normal)};
  const auto with_sign = [&a](const Rational& height) { return Rational(height * abs(height) / a.squared_normal); };
  const Rational above(a.squared_radius + with_sign(Rational(high + std::max(none, a.rise)))),
      below(a.squared_radius - with_sign(Rational(low + std::min(none, a.rise))));
  Parabola f = parabola_of(a);
  return {f.contact(), Rational(abs(std::min(above, below))), [a = std::move(a), f = std::move(f)] {
            return Certificate{f.kind(), {{"polynomial", {a.start(), Rational(2 * a.half()), a.square()}}}};
          }};
}

}  // namespace touchstone::oracle
