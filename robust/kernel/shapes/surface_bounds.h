// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/triangles.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::filters {

/// Bounds of the squared distance of a point from a triangle.
struct SquareBounds {
  double low, high;
};

/// A kernel::ControlWord is in scope; all numbers are finite.
///
/// An estimate q of the point of the triangle that is nearest to p, as seen from p: a sum of corners with weights that
/// are not negative and add up to 1, but for rounding. So the triangle has a point near q, however good the estimate,
/// and its distance is at most that of q; and no point x of it is nearer than the corner that is least far along q
/// makes it: |q| |x| >= q . x >= the least q . corner.
///
/// With u = 2^-53, R the greatest magnitude of a coordinate of a corner as seen from p, and S = |q.x| + |q.y| + |q.z|:
/// corners are off by u R (one difference) and edges by 4 u R; two multiples of edges are rounded, by 2 u R each, and
/// two sums, by 2 u R each; weights add up to at most 1 + 4 u, which moves q by 8 u R. So q is within 20 u R of a point
/// of the triangle on every axis. `high` is Q = q . q with 64 u R S and 2^-90 R^2 added: that covers 40 u R S and 3 (20
/// u R)^2, Q's own roundings, 3 u Q <= 3 u (1.1 R) S, and those of the bound. q . corner is off by 4.1 u R S: 2^-50 R S
/// is subtracted, and the quotient's six roundings are less than 2^-49 of it. Nothing overflows, as numbers are at most
/// 2^200. A sum loses by underflow less than 2^-1070, and R at least 2^-400, so that 2^-90 R^2 covers it; where Q is
/// below 2^-90 R^2, `low` is 0, and otherwise S is at least 2^-45 R, and 2^-50 R S covers it; `low` itself may
/// underflow, but `high` is at least 2^-890. Not proved by machine.
inline SquareBounds bounds_of_square(const Point3d& p, const Triangle3d& triangle) {
  const auto greatest = [](const auto& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); };
  const SquareBounds unknown{0, std::numeric_limits<double>::infinity()};
  if (std::max({greatest(p), greatest(triangle.a), greatest(triangle.b), greatest(triangle.c)}) > 0x1p200)
    return unknown;
  const Vector3d a = triangle.a - p, b = triangle.b - p, c = triangle.c - p;
  Vector3d q = a;
  double square = dot(a, a);
  const auto consider = [&](const Vector3d& x) {
    const double here = dot(x, x);
    if (here < square) q = x, square = here;
  };
  const auto along_edge = [&](const Vector3d& from, const Vector3d& to) {
    const Vector3d edge = to - from;
    const double foot = -dot(from, edge), length = dot(edge, edge);
    consider(foot <= 0 ? from : foot < length ? from + (foot / length) * edge : to);
  };
  const Vector3d e = b - a, f = c - a, normal = cross(e, f);
  const double of_a = dot(cross(b, c), normal), of_b = dot(cross(c, a), normal), of_c = dot(cross(a, b), normal);
  const double sum = of_a + of_b + of_c;
  if (of_a > 0 && of_b > 0 && of_c > 0) consider(a + (of_b / sum) * e + (of_c / sum) * f);
  else along_edge(a, b), along_edge(b, c), along_edge(c, a);
  const double r = std::max({greatest(a), greatest(b), greatest(c)});
  const double s = std::fabs(q.x) + std::fabs(q.y) + std::fabs(q.z);
  if (r < 0x1p-400) return unknown;
  const double high = square + 0x1p-47 * r * s + 0x1p-90 * r * r;
  const double along = std::min({dot(q, a), dot(q, b), dot(q, c)}) - 0x1p-50 * r * s;
  if (!(along > 0) || square < 0x1p-90 * r * r) return {0, high};
  return {(1 - 0x1p-49) * (along / square * along), high};
}

}  // namespace touchstone::robust::filters
