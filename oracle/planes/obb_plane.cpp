// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/obb_plane.h"

#include <utility>
#include <vector>

#include "oracle/exact/shapes/half_space.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> obb_plane(const Obb3<Number>& obb, const Plane<Number>& plane) {
  validate_over_plane("obb", obb, plane);
  const Hull corners = round_solid(obb).core;
  const Plane<Rational> exactly = exact(plane);
  const std::size_t lowest = lowest_of(corners, exactly);
  const Rational least = height_over(exactly, corners[lowest]), of_center = height_over(exactly, exact(obb.center));
  const Contact contact = sgn(least) > 0   ? Contact::disjoint
                          : sgn(least) < 0 ? Contact::overlapping
                                           : Contact::touching;
  return {contact, Rational(least * least / dot(exactly.normal, exactly.normal)), [=]() -> Certificate {
            // From the center towards the lowest corner, half as far as the height falls below 0 at last, or not at
            // all.
            const bool inside = contact == Contact::overlapping, far = inside && sgn(of_center) >= 0;
            const Rational rest = far ? Rational(least / (2 * (least - of_center))) : Rational(1),
                           share = inside ? Rational(1 - rest) : Rational(1);
            std::vector<Rational> coefficients;
            for (std::size_t k = 0; k < 3; ++k) coefficients.push_back(lowest >> k & 1U ? share : Rational(-share));
            return {inside ? "common_interior_point" : "lowest_point", {{"coefficients", std::move(coefficients)}}};
          }};
}
template Truth<Contact> obb_plane(const Obb3d&, const Plane3d&);
template Truth<Contact> obb_plane(const Obb3<Rational>&, const Plane<Rational>&);

}  // namespace touchstone::oracle
