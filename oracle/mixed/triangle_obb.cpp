// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/triangle_obb.h"

#include <array>
#include <utility>
#include <vector>

#include "oracle/exact/numbers/space.h"
#include "oracle/exact/solids/plane_between.h"
#include "oracle/exact/systems/zonotope.h"

namespace touchstone::oracle {
namespace {

using PointsFromCenter = std::vector<Point3<Integer>>;

PointsFromCenter corners_of_half_axes(const std::array<Vector3<Integer>, 3>& half_axes) {
  PointsFromCenter corners;
  for (unsigned i = 0; i < 8; ++i) {
    Point3<Integer> corner{0, 0, 0};
    for (unsigned k = 0; k < 3; ++k) corner = corner + Integer((i >> k & 1U) != 0 ? 1 : -1) * half_axes[k];
    corners.push_back(corner);
  }
  return corners;
}

Certificate certificate_triangle_obb(const Zonotope::Held& held, const PointsFromCenter& triangle,
                                     const PointsFromCenter& box) {
  const auto normal = [](const WitnessPlane& plane) -> std::pair<std::string, std::vector<Rational>> {
    const auto& n = plane.normal;
    return {"normal", {Rational(n.x), Rational(n.y), Rational(n.z)}};
  };
  if (held.growth > 1) return {"separating_axis", {normal(*plane_apart(box, triangle))}};
  Certificate found{"common_interior_point", {{"on_a", held.weights}, {"on_b", held.coefficients}}};
  if (held.growth == 1) found.kind = "supporting_axis", found.facts.push_back(normal(*plane_between(triangle, box)));
  return found;
}

}  // namespace

template <Exact Number>
Truth<Contact> triangle_obb(const Triangle3<Number>& triangle, const Obb3<Number>& obb) {
  validation::validate_numbers("triangle", triangle), validation::validate_numbers("obb", obb);
  validate_parallelepiped("obb", obb);
  const auto& [a, b, c] = triangle;
  const auto& [u, v, w] = obb.half_axes;
  const Point3<Number>& o = obb.center;
  const CommonScale<Number, 21> scale({u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z, o.x, o.y, o.z,  //
                                       a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
  const auto at = [&scale](std::size_t i) {
    return Vector3<Integer>{scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)};
  };
  const std::array half_axes{at(0), at(3), at(6)};
  const auto seen = [&at](std::size_t i) { return Point3<Integer>{0, 0, 0} + (at(i) - at(9)); };
  PointsFromCenter corners{seen(12), seen(15), seen(18)};
  const Zonotope box({half_axes[0], half_axes[1], half_axes[2]});
  Zonotope::Held held = box.held(corners);
  const Rational beyond(held.growth - 1), nearest_face = box.deciding({0, 0, 0}).squared_distance();
  return {sgn(beyond) > 0   ? Contact::disjoint
          : sgn(beyond) < 0 ? Contact::overlapping
                            : Contact::touching,
          scale.actual(Rational(beyond * beyond * nearest_face), 2),
          [held = std::move(held), corners = std::move(corners), of_box = corners_of_half_axes(half_axes)] {
            return certificate_triangle_obb(held, corners, of_box);
          }};
}
template Truth<Contact> triangle_obb(const Triangle3d&, const Obb3d&);
template Truth<Contact> triangle_obb(const Triangle3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
