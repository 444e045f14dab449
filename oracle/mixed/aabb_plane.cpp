// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/aabb_plane.h"

#include <algorithm>

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {
namespace {

using AabbPlanePoint = Point3<Rational>;

/// The corner of the least height.
AabbPlanePoint lowest_corner(const Aabb3<Rational>& box, const Plane<Rational>& plane) {
  AabbPlanePoint lowest = box.min;
  for (const Rational* x : {&box.min.x, &box.max.x})
    for (const Rational* y : {&box.min.y, &box.max.y})
      for (const Rational* z : {&box.min.z, &box.max.z}) {
        const AabbPlanePoint corner{*x, *y, *z};
        if (height_over(plane, corner) < height_over(plane, lowest)) lowest = corner;
      }
  return lowest;
}

Certificate at(const char* kind, const AabbPlanePoint& p) { return {kind, {{"point", {p.x, p.y, p.z}}}}; }

/// From the center towards the lowest corner, half as far as the height falls below 0, or not at all.
Certificate common_interior_point(const AabbPlanePoint& center, const AabbPlanePoint& lowest,
                                  const Plane<Rational>& plane) {
  const Rational of_center = height_over(plane, center), of_lowest = height_over(plane, lowest);
  const bool far = sgn(of_center) >= 0;
  const Rational back = far ? Rational(-of_lowest / (2 * (of_center - of_lowest))) : Rational(1);
  return at("common_interior_point", lowest + back * (center - lowest));
}

}  // namespace

template <Exact Number>
Truth<Contact> aabb_plane(const Aabb3<Number>& aabb, const Plane<Number>& plane) {
  validation::validate_all("aabb", aabb, "plane", plane);
  const Aabb3<Rational> box{exact(aabb.min), exact(aabb.max)};
  const Plane<Rational> exactly = exact(plane);
  const Vector3<Rational> width = box.max - box.min;
  const Rational least = std::min({width.x, width.y, width.z});
  const AabbPlanePoint lowest = lowest_corner(box, exactly);
  const Rational height = height_over(exactly, lowest);
  const Rational gap(height * height / dot(exactly.normal, exactly.normal)), thickness(least * least);
  if (sgn(height) > 0) return {Contact::disjoint, gap, [=] { return at("lowest_point", lowest); }};
  const Rational margin = std::min(gap, thickness);
  if (sgn(margin) > 0) {
    const AabbPlanePoint center = box.min + Rational(1, 2) * width;
    return {Contact::overlapping, margin, [=] { return common_interior_point(center, lowest, exactly); }};
  }
  if (sgn(height) == 0) return {Contact::touching, margin, [=] { return at("lowest_point", lowest); }};
  return {Contact::touching, margin, [=]() -> Certificate {
            const Rational axis = sgn(width.x) == 0 ? 0 : sgn(width.y) == 0 ? 1 : 2;
            return {"flat_axis", {{"point", {lowest.x, lowest.y, lowest.z}}, {"axis", {axis}}}};
          }};
}
template Truth<Contact> aabb_plane(const Aabb3d&, const Plane3d&);
template Truth<Contact> aabb_plane(const Aabb3<Rational>&, const Plane<Rational>&);

}  // namespace touchstone::oracle
