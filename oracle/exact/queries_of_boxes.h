// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "oracle/exact/space.h"

/// What a box or a ray meets of several boxes, one after another: their places in the list.
namespace touchstone::oracle {

template <class Number>
Aabb3<Rational> exact(const Aabb3<Number>& box) {
  return {exact(box.min), exact(box.max)};
}
template <class Number>
Ray3<Rational> exact(const Ray3<Number>& ray) {
  const auto& [o, d] = ray;
  return {exact(o), {exact(d.x), exact(d.y), exact(d.z)}};
}

/// Sorted. Two boxes meet if on each axis neither begins beyond the other's end.
/// Margin: the least, over all boxes, of how far one must be moved to part from the query or to touch it, squared: the
/// longest way along the axes where they are apart, the shortest where they meet.
/// Certificate `each_body`: of each box a point in common, or the axis of a gap.
Truth<std::vector<Index>> met_by(const Aabb3<Rational>& query, const std::vector<Aabb3<Rational>>& boxes);

/// In the order of the first t, ties by place. Of each face's plane, origin + t direction is beyond it by c + s t, and
/// a box is met if none is positive at some t >= 0. That is a linear program in t: its dual has a face that the ray
/// does not approach, or one that it approaches and one that it leaves, weighted so that t cancels. The greatest of
/// these sums is what the ray lacks to meet the box. Margin: the least of what a ray lacks of a box, or has to spare of
/// it, and of the way from one first contact to the next, in units of the direction's greatest component, squared. Of
/// two boxes around the origin, that of the first: whether it begins behind the origin decides their order. Certificate
/// `each_along`: of each box where the ray starts in it, or enters it, or the weights of the dual.
Truth<std::vector<Index>> met_by(const Ray3<Rational>& ray, const std::vector<Aabb3<Rational>>& boxes);

/// Whether a point is in the interior of a box, or a point of a ray.
bool in_interior(const Point3<Rational>& point, const Aabb3<Rational>& box);
bool in_interior(const Ray3<Rational>& ray, const Aabb3<Rational>& box);

}  // namespace touchstone::oracle
