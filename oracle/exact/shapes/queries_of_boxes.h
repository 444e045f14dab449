// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/shapes/body_tree.h"

/// The bodies of a tree that a box or a ray meets.
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
/// Margin, if it is less than what is there: the least, over all boxes, of how far one must be moved to part from the
/// query or to touch it, squared: the longest way along the axes where they are apart, the shortest where they meet. A
/// node that is farther away is not looked into.
std::vector<Index> met_by(const Aabb3<Rational>& query, const BodyTree& tree, const Bodies& bodies,
                          std::optional<Rational>& margin);

/// In the order of the first t, ties by index. The point origin + t direction is beyond each face's plane by c + s t,
/// and a box is met if none is positive at some t >= 0. That is a linear program in t: its dual has a face that the ray
/// does not approach, or one that it approaches and one that it leaves, weighted so that t cancels. The greatest of
/// these sums is what the ray lacks to meet the box. Margin: the least of what a ray lacks of a box, or has to spare of
/// it, and of the distance from one first contact to the next, in units of the direction's greatest component, squared.
/// For two boxes around the origin, that of the first: whether it begins behind the origin decides their order.
std::vector<Index> met_by(const Ray3<Rational>& ray, const BodyTree& tree, const Bodies& bodies,
                          std::optional<Rational>& margin);

/// In preorder of the tree, for each node that has children and existing bodies: `open`, and then its children's
/// proofs; or why the query misses its box. For each body of a leaf, then of each body that came later, by index: a
/// point in common, or the axis of a gap; for a ray, whether it starts in the box, or enters it, or the weights of the
/// dual.
std::vector<Certificate> proofs_of(const Aabb3<Rational>& query, const BodyTree& tree, const Bodies& bodies);
std::vector<Certificate> proofs_of(const Ray3<Rational>& ray, const BodyTree& tree, const Bodies& bodies);

/// True if a point is in the interior of a box, or a point of a ray.
bool in_interior(const Point3<Rational>& point, const Aabb3<Rational>& box);
bool in_interior(const Ray3<Rational>& ray, const Aabb3<Rational>& box);

}  // namespace touchstone::oracle
