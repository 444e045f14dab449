// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "catalogue/shape/walk.h"
#include "geometry/answers.h"
#include "simulate/world/arithmetic.h"

/// Questions about bodies in flight that are not operations of the catalogue: closed formulas over float, double or
/// Exact, and for robust the exact one, rounded once.
namespace touchstone::simulate {

/// A height above a wall, times the length of the wall's normal, over the time from 0 to 1: start + slope t + curve
/// t^2.
template <class Real>
struct Height {
  Real start, slope, curve;
};

/// The first t from 0 to 1 at which the height is not above 0 and is falling. A body that rises out of a wall, or from
/// it, may return to it; one that only touches at its lowest point or rests does not fall.
template <class Real>
FirstContact<Real> first_fall(const Height<Real>& height) {
  using std::sqrt;
  const auto& [e, s, c] = height;
  const FirstContact<Real> never{HitRelation::never, std::nullopt};
  const Real zero(0);
  if (e <= zero && s < zero) return {HitRelation::hit, zero};
  if (!(c < zero) && (e <= zero || !(s < zero))) return never;
  const Real discriminant = Real(Real(s * s) - Real(Real(Real(4) * e) * c));
  if (!(discriminant > zero)) return never;
  const Real root = Real(sqrt(discriminant));
  // The same root in two forms, each used where it has no cancellation.
  const Real t = s > zero ? Real(Real(-s - root) / Real(Real(2) * c)) : Real(Real(Real(2) * e) / Real(root - s));
  if (zero <= t && t <= Real(1)) return {HitRelation::hit, t};
  return never;
}

/// The height of a ball, or with radius 0 of a point, with this initial velocity and acceleration, where t = 1 is after
/// `time`.
template <class Real>
Height<Real> height_over(const Sphere3<Real>& ball, const Vector3<Real>& velocity, const Vector3<Real>& acceleration,
                         const Real& time, const Plane<Real>& wall) {
  using std::sqrt;
  const auto& [n, offset] = wall;
  const auto& [center, radius] = ball;
  const Real along = Real(dot(n, Vector3<Real>{center.x, center.y, center.z}) + offset),
             reach = radius == Real(0) ? radius : Real(radius * Real(sqrt(Real(dot(n, n)))));
  return {Real(along - reach), Real(time * Real(dot(n, velocity))),
          Real(Real(Real(time * time) * Real(dot(n, acceleration))) / Real(2))};
}

/// The first t from 0 to 1 at which a ball that moves by `way` has a point in common with a box at rest. The ball's
/// center then enters the box grown by its radius, rounded at edges and corners: its squared distance from the box is a
/// quadratic polynomial between the times at which it crosses the planes of the faces, and convex.
template <class Real>
FirstContact<Real> swept_sphere_aabb(const Sphere3<Real>& ball, const Aabb3<Real>& box,
                                     const Vector3<Real>& displacement) {
  using std::sqrt;
  const FirstContact<Real> never{HitRelation::never, std::nullopt};
  const Real zero(0), one(1);
  struct Axis {
    Real place, displacement, low, high;
  };
  const auto& [center, radius] = ball;
  const std::array<Axis, 3> axes{Axis{center.x, displacement.x, box.min.x, box.max.x},
                                 Axis{center.y, displacement.y, box.min.y, box.max.y},
                                 Axis{center.z, displacement.z, box.min.z, box.max.z}};
  std::vector<Real> moments{zero, one};
  for (const auto& [place, speed, low, high] : axes) {
    for (const Real& face : {low, high}) {
      const Real t = Real(Real(face - place) / speed);
      if (zero < t && t < one) moments.push_back(t);
    }
  }
  std::sort(moments.begin(), moments.end());
  for (std::size_t i = 0; i + 1 < moments.size(); ++i) {
    const Real &from = moments[i], &to = moments[i + 1], middle = Real(Real(from + to) / Real(2));
    Real square = zero, half = zero, start = Real(-Real(radius * radius));
    for (const auto& [place, speed, low, high] : axes) {
      const Real at = Real(place + Real(middle * speed));
      if (low <= at && at <= high) continue;
      const Real apart = Real(place - (at < low ? low : high));
      square = Real(square + Real(speed * speed)), half = Real(half + Real(apart * speed));
      start = Real(start + Real(apart * apart));
    }
    const auto value = [&](const Real& t) {
      return Real(Real(Real(Real(square * t) + Real(Real(2) * half)) * t) + start);
    };
    if (value(from) <= zero) return {HitRelation::hit, from};
    const bool turns = Real(half + Real(square * from)) < zero && zero < Real(half + Real(square * to));
    if (!(value(to) <= zero) && !turns) continue;
    const Real discriminant = Real(Real(half * half) - Real(square * start));
    if (discriminant < zero) continue;
    const Real t = Real(start / Real(Real(sqrt(discriminant)) - half));
    return {HitRelation::hit, std::min(std::max(t, from), to)};
  }
  return never;
}

/// True if a body that leaves a wall at this velocity and repeatedly falls back to it, at `restitution` times the speed
/// each time, completes all of these bounces within `time`: together they take 2 v / g (1 + e + e^2 + ...).
template <class Real>
bool bounces_end(const Vector3<Real>& velocity, const Vector3<Real>& acceleration, const Vector3<Real>& normal,
                 const Real& restitution, const Real& time) {
  const Real speed = Real(dot(normal, velocity)), pull = Real(-Real(dot(normal, acceleration)));
  return pull > Real(0) && Real(Real(2) * speed) <= Real(Real(pull * Real(Real(1) - restitution)) * time);
}

/// The vector nearest to `pull` that leads into no wall with these normals: itself, or its projection on a plane, or on
/// the line of two planes, or 0.
template <class Real>
Vector3<Real> nearest_not_into(const Vector3<Real>& pull, const std::vector<Vector3<Real>>& normals) {
  const Real zero(0);
  Vector3<Real> nearest{zero, zero, zero};
  Real least = dot(pull, pull);
  const auto try_foot = [&](const Vector3<Real>& foot, std::size_t first, std::size_t second) {
    for (std::size_t m = 0; m < normals.size(); ++m)
      if (m != first && m != second && dot(normals[m], foot) < zero) return;
    const Vector3<Real> off = pull - foot;
    if (const Real square = dot(off, off); square < least) least = square, nearest = foot;
  };
  const std::size_t none = normals.size();
  try_foot(pull, none, none);
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const Vector3<Real>& n = normals[k];
    try_foot(pull - Real(dot(pull, n) / dot(n, n)) * n, k, k);
    for (std::size_t l = 0; l < k; ++l) {
      const Vector3<Real> line = cross(n, normals[l]);
      const Real square = dot(line, line);
      if (square > zero) try_foot(Real(dot(pull, line) / square) * line, k, l);
    }
  }
  return nearest;
}

/// A formula in that arithmetic: for robust the exact one, with each number of its answer rounded once.
template <class By, class Formula, class... Part>
auto by(const Formula& formula, const Part&... part) {
  if constexpr (std::is_same_v<By, Robust>) {
    const auto exact = [](double x) { return Formulas<Exact>::number(x); };
    return catalogue::converted<double>(formula(catalogue::converted<Exact>(part, exact)...),
                                        [](const Exact& x) { return catalogue::nearest(x.value()); });
  } else {
    return formula(part...);
  }
}

}  // namespace touchstone::simulate
