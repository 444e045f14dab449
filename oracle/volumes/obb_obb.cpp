// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/obb_obb.h"

#include <utility>

#include "oracle/exact/systems/zonotope.h"

namespace touchstone::oracle {
namespace {

/// The half axes of both as edges, and the displacement from a's center to b's, in units of the scale.
template <class Number>
struct ObbObbPair {
  CommonScale<Number, 24> scale;
  Zonotope differences;
  Vector3<Integer> displacement;
};

template <class Number>
ObbObbPair<Number> validated_obb_obb(const Obb3<Number>& a, const Obb3<Number>& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  validate_parallelepiped("a", a), validate_parallelepiped("b", b);
  const Point3<Number>&c = a.center, &d = b.center;
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  CommonScale<Number, 24> scale({u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z, x.x, x.y, x.z,  //
                                 y.x, y.y, y.z, z.x, z.y, z.z, c.x, c.y, c.z, d.x, d.y, d.z});
  const auto at = [&scale](std::size_t i) {
    return Vector3<Integer>{scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)};
  };
  Zonotope differences({at(0), at(3), at(6), at(9), at(12), at(15)});
  Vector3<Integer> displacement = at(21) - at(18);
  return {std::move(scale), std::move(differences), std::move(displacement)};
}

Certificate certificate_obb_obb(const Zonotope::Held& held, const Vector3<Integer>& n) {
  const std::pair<std::string, std::vector<Rational>> normal{"normal", {Rational(n.x), Rational(n.y), Rational(n.z)}};
  if (held.growth > 1) return {"separating_axis", {normal}};
  // a's center plus its half axes times these is the same point as b's center minus its half axes times the others.
  const auto& r = held.coefficients;
  Certificate found{"common_interior_point",
                    {{"on_a", {r[0], r[1], r[2]}}, {"on_b", {Rational(-r[3]), Rational(-r[4]), Rational(-r[5])}}}};
  if (held.growth == 1) found.kind = "supporting_axis", found.facts.push_back(normal);
  return found;
}

}  // namespace

template <Exact Number>
Truth<Contact> obb_obb(const Obb3<Number>& a, const Obb3<Number>& b) {
  const ObbObbPair<Number> pair = validated_obb_obb(a, b);
  Zonotope::Held held = pair.differences.held(pair.displacement);
  Zonotope::Support support = pair.differences.deciding(pair.displacement);
  return {held.growth < 1   ? Contact::overlapping
          : held.growth > 1 ? Contact::disjoint
                            : Contact::touching,
          pair.scale.actual(support.squared_distance(), 2),
          [held = std::move(held), normal = std::move(support.normal)] { return certificate_obb_obb(held, normal); }};
}
template Truth<Contact> obb_obb(const Obb3d&, const Obb3d&);
template Truth<Contact> obb_obb(const Obb3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
