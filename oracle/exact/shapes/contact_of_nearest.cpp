// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/contact_of_nearest.h"

#include <algorithm>

namespace touchstone::oracle {

Truth<Contact> contact_of_nearest(const Rational& squared_distance, const std::vector<Rational>& radii,
                                  std::vector<std::pair<std::string, std::vector<Rational>>> weights) {
  Rational sum;
  for (const Rational& radius : radii) sum += radius;
  const Rational reach(sum * sum), depth(reach - squared_distance);
  Rational margin = abs(depth);
  if (sgn(depth) >= 0) {
    for (const Rational& radius : radii) {
      const Rational others(sum - radius);
      margin = std::min(margin, Rational(reach - others * others));
    }
  }
  const Contact contact = sgn(depth) < 0    ? Contact::disjoint
                          : sgn(margin) > 0 ? Contact::overlapping
                                            : Contact::touching;
  const char* kind = contact == Contact::disjoint      ? "nearest_points"
                     : contact == Contact::overlapping ? "near_points"
                     : sgn(depth) == 0                 ? "tangent"
                                                       : "no_interior";
  return {contact, margin, [kind, facts = std::move(weights)]() -> Certificate { return {kind, facts}; }};
}

}  // namespace touchstone::oracle
