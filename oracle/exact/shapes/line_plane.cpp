// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/line_plane.h"

#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {

LinePlaneHeights::LinePlaneHeights(const Point3<Rational>& from, const Point3<Rational>& to,
                                   const Plane<Rational>& plane)
    : from_(from),
      to_(to),
      at_start_(height_over(plane, from)),
      at_end_(height_over(plane, to)),
      squared_normal_(dot(plane.normal, plane.normal)) {}

LinePlane<Rational> LinePlaneHeights::common(bool ends) const {
  if (at_start_ == at_end_)
    return {sgn(at_start_) == 0 ? LinePlaneRelation::inside : LinePlaneRelation::none, std::nullopt, std::nullopt};
  // The weighted heights add up to 0, and the weights to 1.
  const Rational of_from(at_end_ / (at_end_ - at_start_)), of_to(1 - of_from);
  if (sgn(of_to) < 0 || (ends && sgn(of_from) < 0)) return {LinePlaneRelation::none, std::nullopt, std::nullopt};
  const auto weighted = [&](const Rational& p, const Rational& q) { return Rational(of_from * p + of_to * q); };
  return {LinePlaneRelation::point, of_to,
          Point3<Rational>{weighted(from_.x, to_.x), weighted(from_.y, to_.y), weighted(from_.z, to_.z)}};
}

}  // namespace touchstone::oracle
