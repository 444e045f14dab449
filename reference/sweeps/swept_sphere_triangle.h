// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// The formula of swept_sphere_triangle for a convex polygon, its corners in order.
template <class Real, std::size_t size>
FirstContact<Real> ball_to_polygon(const Sphere3<Real>& sphere, const Vector3<Real>& velocity,
                                   const std::array<Point3<Real>, size>& corners) {
  using std::sqrt;
  const Real none(0), one(1), squared_radius = Real(sphere.radius * sphere.radius);
  const auto square = [](const Vector3<Real>& v) { return Real(dot(v, v)); };
  const auto way = [&](std::size_t k) { return sphere.center - corners[k]; };
  const auto edge = [&](std::size_t k) { return corners[(k + 1) % size] - corners[k]; };
  const Vector3<Real> normal = cross(edge(0), edge(1));
  FirstContact<Real> first{HitRelation::never, std::nullopt};
  // The height of the center at t over a plane through a corner.
  const auto height = [&](const Vector3<Real>& n, std::size_t k, const Real& t) {
    return Real(dot(n, way(k)) + Real(t * Real(dot(n, velocity))));
  };
  const auto count = [&](const Real& t, const auto& over) {
    if (none <= t && t <= one && !(first.t && *first.t <= t) && over(t)) first = {HitRelation::hit, t};
  };
  // The first zero of a t^2 + 2 h t + g.
  const auto enter = [&](const Vector3<Real>& start, const Vector3<Real>& rise, const Real& reach, const auto& over) {
    const Real g = Real(square(start) - reach), h = dot(start, rise), a = square(rise);
    if (g <= none) return count(none, over);
    const Real discriminant = Real(Real(h * h) - Real(a * g));
    if (h < none && none <= discriminant) count(Real(Real(-h - Real(sqrt(discriminant))) / a), over);
  };
  for (std::size_t k = 0; k < size; ++k) {
    const Vector3<Real> e = edge(k);
    enter(way(k), velocity, squared_radius, [](const Real&) { return true; });
    if (none < square(e))
      enter(cross(way(k), e), cross(velocity, e), Real(squared_radius * square(e)),
            [&](const Real& t) { return none <= height(e, k, t) && height(e, (k + 1) % size, t) <= none; });
  }
  if (none < square(normal)) {
    const Real h = dot(normal, way(0)), rise = dot(normal, velocity),
               reach = Real(sphere.radius * Real(sqrt(square(normal))));
    const Real gap = Real((h < none ? Real(-h) : h) - reach);
    count(gap <= none ? none : Real(gap / (h < none ? rise : Real(-rise))), [&](const Real& t) {
      for (std::size_t k = 0; k < size; ++k)
        if (height(cross(normal, edge(k)), k, t) < none) return false;
      return true;
    });
  }
  return first;
}

/// Finds when a ball that moves along a straight line first has a common point with a closed triangle in space, by its
/// face, its edges and its corners.
///
/// No page of the deck asks this. The formula is that of Fauerby, Improved Collision Detection and Response (2003),
/// made of p. 23's times and roots: the ball meets the plane of the triangle at t = (|h| - r |N|) / s, h being the
/// height of the center over it at the start and s what it loses in a step, both in units of |N|, which counts if its
/// center is over the triangle then; an edge e of the triangle at the first zero of |w x e|^2 - r^2 |e|^2, w leading
/// from an end of the edge to the center, which counts if the center is between the ends of the edge then; a corner at
/// the first zero of |w|^2 - r^2. Where such a polynomial, or |h| - r |N|, is not positive at the start, its t is 0.
/// `hit` with the least t in [0, 1] that counts, otherwise `never`. sphere, triangle: any unit of length, the same for
/// both; velocity in that unit a step, of the ball, while the triangle rests; t counts in steps. Closed sets: touching
/// is a hit, also where the ball only grazes the triangle, slides along it, or touches it at the start or at the end.
/// The triangle has two sides and no interior; one without area is the segment or the point that its corners span. The
/// truth is `hit` with t = 0 if they have a common point at the start, otherwise with the first t in [0, 1] where they
/// have: that t, in general a number with a square root. Radius 0 is a point; a velocity of 0 is valid. NaN or
/// infinity: refused by robust and oracle (field "sphere.center[0]", "triangle[0][0]" ..., "finite number"); so is a
/// negative radius ("sphere.radius", "radius >= 0").
///
/// In exact arithmetic the formula is always right: all centers that are no farther than r from the triangle are in the
/// slab over its face, in a cylinder around an edge, or in a ball around a corner, and the first of these that the
/// center enters over its face or edge is entered at the first zero.
///
/// Margin: |m - r^2|, m being the least squared distance of the center from the triangle during the step; if the center
/// crosses the triangle, r^2 + d^2, d being the distance by which its path has to be moved until it does not. 0 if the
/// ball only grazes the triangle, or touches it at the end, or at the start and comes no nearer.
///
/// Rounding: no bound is given. A rounded time may be over another part of the triangle than the exact one, and a
/// discriminant that cancels decides whether an edge is met. ulps: 53 roundings behind t (three differences in each of
/// w and e; nine in each of w x e and v x e; five in each of their three products, five in |e|^2, two with r^2, and a
/// difference; three in the discriminant; root, sum, quotient).
template <class Real>
FirstContact<Real> swept_sphere_triangle(const Sphere3<Real>& sphere, const Vector3<Real>& velocity,
                                         const Triangle3<Real>& triangle) {
  const auto& [a, b, c] = triangle;
  return ball_to_polygon<Real, 3>(sphere, velocity, {a, b, c});
}

}  // namespace touchstone::reference
