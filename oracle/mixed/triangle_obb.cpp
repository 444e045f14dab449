// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/triangle_obb.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "oracle/exact/numbers/space.h"
#include "oracle/exact/solids/plane_between.h"
#include "oracle/exact/systems/zonotope.h"

namespace touchstone::oracle {
namespace {

using Corners = std::vector<Vector3<Integer>>;

/// Seen from the center of the box.
std::vector<Point3<Integer>> as_points(const Corners& corners) {
  std::vector<Point3<Integer>> points;
  for (const Vector3<Integer>& v : corners) points.push_back({v.x, v.y, v.z});
  return points;
}

Corners corners_of_half_axes(const std::array<Vector3<Integer>, 3>& half_axes) {
  Corners corners;
  for (unsigned i = 0; i < 8; ++i) {
    Vector3<Integer> corner{0, 0, 0};
    for (unsigned k = 0; k < 3; ++k) corner = corner + Integer((i >> k & 1U) != 0 ? 1 : -1) * half_axes[k];
    corners.push_back(corner);
  }
  return corners;
}

/// From the center to the plane of the nearest face.
Rational squared_distance_of_faces(const std::array<Vector3<Integer>, 3>& half_axes) {
  const auto& [u, v, w] = half_axes;
  const Integer volume = dot(cross(u, v), w);
  Integer most;
  for (const Vector3<Integer>& n : {cross(u, v), cross(v, w), cross(w, u)}) most = std::max(most, Integer(dot(n, n)));
  return quotient(Integer(volume * volume), most);
}

Certificate certificate_triangle_obb(const Zonotope::Held& held, const Corners& triangle, const Corners& box) {
  const auto normal = [](const WitnessPlane& plane) -> std::pair<std::string, std::vector<Rational>> {
    const auto& n = plane.normal;
    return {"normal", {Rational(n.x), Rational(n.y), Rational(n.z)}};
  };
  if (held.growth > 1) return {"separating_axis", {normal(*plane_apart(as_points(box), as_points(triangle)))}};
  Certificate found{"common_interior_point", {{"on_a", held.weights}, {"on_b", held.coefficients}}};
  if (held.growth == 1) {
    found.kind = "supporting_axis";
    found.facts.push_back(normal(*plane_between(as_points(triangle), as_points(box))));
  }
  return found;
}

template <class Number>
Truth<Contact> truth_triangle_obb(const Triangle3<Number>& triangle, const Obb3<Number>& obb) {
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
  Corners corners{at(12) - at(9), at(15) - at(9), at(18) - at(9)};
  Zonotope::Held held = Zonotope({half_axes[0], half_axes[1], half_axes[2]}).held(corners);
  const Rational beyond(held.growth - 1);
  return {sgn(beyond) > 0   ? Contact::disjoint
          : sgn(beyond) < 0 ? Contact::overlapping
                            : Contact::touching,
          scale.actual(Rational(beyond * beyond * squared_distance_of_faces(half_axes)), 2),
          [held = std::move(held), corners = std::move(corners), box = corners_of_half_axes(half_axes)] {
            return certificate_triangle_obb(held, corners, box);
          }};
}

}  // namespace

Truth<Contact> triangle_obb(const Triangle3d& triangle, const Obb3d& obb) { return truth_triangle_obb(triangle, obb); }

template <Exact Number>
Truth<Contact> triangle_obb(const Triangle3<Number>& triangle, const Obb3<Number>& obb) {
  return truth_triangle_obb(triangle, obb);
}
template Truth<Contact> triangle_obb(const Triangle3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
