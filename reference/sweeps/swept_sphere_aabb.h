// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/answers.h"
#include "reference/sweeps/swept_aabb_aabb.h"

namespace touchstone::reference {

/// Finds when a ball that moves along a straight line first has a common point with an axis-aligned box, by the box
/// grown by the radius, and the capsules around its edges.
///
/// No page of the deck asks this. The formula is that of Ericson, Real-Time Collision Detection, 5.5.7, made of p.
/// 45-47's intervals and p. 23's roots. The center first has to enter the box that is grown by r on every axis, at a
/// time that the axes' entries and exits tell (swept_aabb_aabb.h). There it is beyond the box on some axes: on one or
/// none, and this is the contact; on two, and then the center has to enter the capsule of radius r around the edge
/// between these two faces; on three, and then one of the capsules around the three edges of that corner. A capsule is
/// entered through the cylinder around its edge, where at the root t = (-h - sqrt(h^2 - a g)) / a of a t^2 + 2 h t + g
/// the center is between the ends, or through the ball at an end. `hit` with the least t in [0, 1], otherwise `never`.
/// sphere, aabb: any unit of length, the same for both; velocity in that unit a step, of the ball, while the box rests;
/// t counts in steps. Closed sets: touching is a hit, also where the ball only grazes the box, slides along it, or
/// touches it at the start or at the end. The box is solid: a ball within it meets it. The truth is `hit` with t = 0 if
/// they have a common point at the start, otherwise with the first t in [0, 1] where they have: that t, in general a
/// number with a square root. Radius 0 is a point; min == max is valid on any axis: a flat box; so is a velocity of 0.
/// NaN or infinity: refused by robust and oracle (field "sphere.center[0]" ..., "finite number"); so are a negative
/// radius ("sphere.radius", "radius >= 0") and min > max ("aabb.max[0]" ..., "min <= max").
///
/// In exact arithmetic the formula is always right. The grown box holds every center that is no farther than r from the
/// box, and besides only centers that are beyond it on two or three axes. From beyond two faces the center comes over
/// one of them only through the capsule between them. It reaches no other edge first: it crosses the plane of a third
/// face, where it is no farther than r from the line of that edge, because it is in the grown box, and then the plane
/// of one of the two, where it is farther than r from the corner, which is then the nearest point of that line. The
/// distance from a line is convex in t, so it grows from then on.
///
/// Margin: |m - r^2|, m being the least squared distance of the center from the box during the step; if the center
/// enters the box, r^2 + d^2, d being the distance by which its path has to be moved, in the maximum norm, until it
/// does not. 0 if the ball only grazes the box, or touches it at the start and parts, or at the end.
///
/// Rounding: no bound is given. A rounded entry may be beyond other faces than the exact one, and a discriminant that
/// cancels decides whether a capsule is entered. ulps: 26 roundings behind t (three differences; five in each of a and
/// h, seven in g; three in the discriminant; root, sum, quotient).
template <class Real>
FirstContact<Real> swept_sphere_aabb(const Sphere3<Real>& sphere, const Vector3<Real>& velocity,
                                     const Aabb3<Real>& aabb) {
  using std::sqrt;
  using Triple = std::array<Real, 3>;
  const Real &r = sphere.radius, none(0), one(1);
  const Triple c{sphere.center.x, sphere.center.y, sphere.center.z}, v{velocity.x, velocity.y, velocity.z},
      min{aabb.min.x, aabb.min.y, aabb.min.z}, max{aabb.max.x, aabb.max.y, aabb.max.z};
  CommonTime<Real> time;
  for (std::size_t k = 0; k < 3; ++k) time.cut(c[k], c[k], Real(min[k] - r), Real(max[k] + r), v[k]);
  const FirstContact<Real> entry = time.contact();
  if (!entry.t) return entry;
  std::array<bool, 3> beyond{};
  Triple corner = min;
  for (std::size_t k = 0; k < 3; ++k) {
    const Real x = Real(c[k] + Real(*entry.t * v[k]));
    beyond[k] = x < min[k] || max[k] < x;
    if (max[k] < x) corner[k] = max[k];
  }
  const int count = beyond[0] + beyond[1] + beyond[2];
  if (count < 2) return entry;
  FirstContact<Real> first{HitRelation::never, std::nullopt};
  // Around a corner, or around the line of an edge, without the axis along which that leads.
  const auto enter = [&](const Triple& p, std::size_t edge) {
    Real square(0), half(0), gap = Real(-Real(r * r));
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == edge) continue;
      const Real d = Real(c[k] - p[k]);
      square = Real(square + Real(v[k] * v[k])), half = Real(half + Real(d * v[k])), gap = Real(gap + Real(d * d));
    }
    Real t(0);
    if (gap > none) {
      const Real discriminant = Real(Real(half * half) - Real(square * gap));
      if (!(half < none) || discriminant < none) return;
      t = Real(Real(-half - Real(sqrt(discriminant))) / square);
    }
    if (!(t <= one) || (first.t && *first.t <= t)) return;
    if (edge < 3) {
      const Real x = Real(c[edge] + Real(t * v[edge]));
      if (x < min[edge] || max[edge] < x) return;
    }
    first = {HitRelation::hit, t};
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (count == 2 && beyond[k]) continue;
    Triple end = corner;
    enter(corner, k);
    for (const Real& side : {min[k], max[k]}) end[k] = side, enter(end, 3);
  }
  return first;
}

}  // namespace touchstone::reference
