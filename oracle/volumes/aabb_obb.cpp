// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/aabb_obb.h"

#include <algorithm>
#include <array>
#include <utility>

#include "oracle/exact/systems/zonotope.h"

namespace touchstone::oracle {
namespace {

Certificate certificate_aabb_obb(const Zonotope::Held& held, const Vector3<Integer>& n, std::size_t flat_axis) {
  const std::pair<std::string, std::vector<Rational>> normal{"normal", {Rational(n.x), Rational(n.y), Rational(n.z)}};
  if (held.growth > 1) return {"separating_axis", {normal}};
  std::vector<Rational> coefficients;
  for (std::size_t k = 3; k < 6; ++k) coefficients.push_back(Rational(-held.coefficients[k]));
  Certificate found{"common_interior_point", {{"coefficients", std::move(coefficients)}}};
  if (held.growth == 1) {
    found.kind = "supporting_axis", found.facts.push_back(normal);
  } else if (flat_axis < 3) {
    found.kind = "flat_axis", found.facts.push_back({"axis", {Rational(static_cast<std::uint64_t>(flat_axis))}});
  }
  return found;
}

}  // namespace

/// Everything is twice as long, in units of the scale.
template <Exact Number>
Truth<Contact> aabb_obb(const Aabb3<Number>& aabb, const Obb3<Number>& obb) {
  validation::validate_numbers("aabb", aabb), validation::validate_numbers("obb", obb);
  validation::validate("aabb", aabb), validate_parallelepiped("obb", obb);
  const auto& [min, max] = aabb;
  const auto& [u, v, w] = obb.half_axes;
  const Point3<Number>& c = obb.center;
  const CommonScale<Number, 18> scale(
      {u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z, min.x, min.y, min.z, max.x, max.y, max.z, c.x, c.y, c.z});
  const auto at = [&scale](std::size_t i) {
    return Vector3<Integer>{scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)};
  };
  const Integer zero(0), two(2);
  const Vector3<Integer> width = at(12) - at(9), displacement = two * at(15) - (at(9) + at(12));
  const Zonotope differences(
      {{width.x, zero, zero}, {zero, width.y, zero}, {zero, zero, width.z}, two * at(0), two * at(3), two * at(6)});
  Zonotope::Held held = differences.held(displacement);
  Zonotope::Support support = differences.deciding(displacement);
  const std::array<Integer, 3> widths{width.x, width.y, width.z};
  const auto least = std::min_element(widths.begin(), widths.end());
  const bool flat = sgn(*least) == 0;
  Rational margin(support.squared_distance() / 4);
  if (held.growth <= 1) margin = std::min(margin, Rational(*least * *least));
  return {held.growth > 1            ? Contact::disjoint
          : held.growth == 1 || flat ? Contact::touching
                                     : Contact::overlapping,
          scale.actual(margin, 2),
          [held = std::move(held), normal = std::move(support.normal),
           axis = flat ? static_cast<std::size_t>(least - widths.begin()) : 3] {
            return certificate_aabb_obb(held, normal, axis);
          }};
}
template Truth<Contact> aabb_obb(const Aabb3d&, const Obb3d&);
template Truth<Contact> aabb_obb(const Aabb3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
