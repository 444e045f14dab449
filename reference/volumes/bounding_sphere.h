// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/volumes.h"

namespace touchstone::reference {

template <class Real>
Real squared_distance(const Point3<Real>& p, const Point3<Real>& q) {
  const Vector3<Real> v = q - p;
  return dot(v, v);
}

/// The ball around a center that reaches the point farthest from it.
template <class Real>
Sphere3<Real> reaching_farthest(const Point3<Real>& center, const std::vector<Point3<Real>>& points) {
  using std::sqrt;
  Real farthest = squared_distance(center, points[0]);
  for (const Point3<Real>& p : points) {
    const Real distance = squared_distance(center, p);
    if (distance > farthest) farthest = distance;
  }
  return {center, Real(sqrt(farthest))};
}

template <class Real>
Point3<Real> middle(const Point3<Real>& p, const Point3<Real>& q) {
  return {Real((p.x + q.x) / Real(2)), Real((p.y + q.y) / Real(2)), Real((p.z + q.z) / Real(2))};
}

/// The first points with the least and with the greatest coordinate.
template <class Real>
std::pair<std::size_t, std::size_t> ends_along(Real Point3<Real>::*axis, const std::vector<Point3<Real>>& points) {
  std::size_t low = 0, high = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].*axis < points[low].*axis) low = i;
    if (points[i].*axis > points[high].*axis) high = i;
  }
  return {low, high};
}

template <class Real>
std::array<std::pair<std::size_t, std::size_t>, 3> ends_of_axes(const std::vector<Point3<Real>>& points) {
  return {ends_along(&Point3<Real>::x, points), ends_along(&Point3<Real>::y, points),
          ends_along(&Point3<Real>::z, points)};
}

/// Ritter: a ball over the widest of the three pairs, which then grows to every point outside of it.
template <class Real>
Sphere3<Real> growing_ball(const std::vector<Point3<Real>>& points) {
  using std::sqrt;
  std::size_t a = 0, b = 0;
  for (const auto& [low, high] : ends_of_axes(points))
    if (squared_distance(points[low], points[high]) > squared_distance(points[a], points[b])) a = low, b = high;
  Sphere3<Real> ball{middle(points[a], points[b]), Real(Real(sqrt(squared_distance(points[a], points[b]))) / Real(2))};
  for (const Point3<Real>& p : points) {
    const Real square = squared_distance(ball.center, p);
    if (!(square > ball.radius * ball.radius)) continue;
    const Real distance = Real(sqrt(square)), radius = Real((ball.radius + distance) / Real(2));
    ball = {ball.center + Real((distance - radius) / distance) * (p - ball.center), radius};
  }
  return ball;
}

/// A ball by its center and the square of its radius; radius_squared < 0: it is empty.
template <class Real>
struct SquaredBall {
  Point3<Real> center;
  Real radius_squared;
};

/// The smallest ball with these points, four at most, on its boundary: its center is from[0] + n / d.
template <class Real>
SquaredBall<Real> ball_through(const std::vector<Point3<Real>>& from) {
  const auto around = [&from](const Vector3<Real>& n, const Real& d) {
    const Vector3<Real> displacement{Real(n.x / d), Real(n.y / d), Real(n.z / d)};
    return SquaredBall<Real>{from[0] + displacement, dot(displacement, displacement)};
  };
  if (from.empty()) return {{Real(0), Real(0), Real(0)}, Real(-1)};
  if (from.size() == 1) return {from[0], Real(0)};
  const Vector3<Real> u = from[1] - from[0];
  if (from.size() == 2) return around(u, Real(2));
  const Vector3<Real> v = from[2] - from[0], n = cross(u, v);
  if (from.size() == 3) return around(cross(dot(u, u) * v - dot(v, v) * u, n), Real(Real(2) * dot(n, n)));
  const Vector3<Real> w = from[3] - from[0];
  return around(dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * n, Real(Real(2) * dot(n, w)));
}

/// Welzl: the smallest ball around the first `count` points with all of `on` on its boundary. A point outside of the
/// ball found so far lies on the boundary of the one that is sought, and is moved to the front.
template <class Real>
SquaredBall<Real> smallest_ball(std::vector<Point3<Real>>& points, std::size_t count, std::vector<Point3<Real>>& on) {
  SquaredBall<Real> ball = ball_through(on);
  if (on.size() == 4) return ball;
  for (std::size_t i = 0; i < count; ++i) {
    const Point3<Real> p = points[i];
    if (!(squared_distance(ball.center, p) > ball.radius_squared)) continue;
    on.push_back(p);
    ball = smallest_ball(points, i, on);
    on.pop_back();
    for (std::size_t k = i; k > 0; --k) points[k] = points[k - 1];
    points[0] = p;
  }
  return ball;
}

/// A ball around points in space: a bounding volume that has to contain every one of them.
///
/// Deck p. 31-34. method `box`: around the center of the points' box, as far as the farthest point; `centroid`: the
/// same around the mean of the points; `ritter`: the ball over the widest of three pairs, the first point with the
/// least and the first with the greatest coordinate on each axis (of equally wide pairs the first; no pair, the first
/// point), grows: for one point after the other that is outside, to the smallest ball that contains the point and the
/// ball; `smallest`: the one smallest ball (Welzl 1991). In JSON the method may be left out: `smallest`.
/// points: any unit of length; at least one. They may be equal, on one line, on one plane, on one sphere; the ball of
/// equal points is that point, with radius 0.
/// Right is a ball, of the doubles that are returned, that contains every point exactly: |p - center| <= radius,
/// closed; and that is not too large: by K units in the last place of the greatest coordinate, and as many of the
/// radius, at most larger than the exact ball of the method (`ritter`: than 3/2 of the smallest). K is 4 for box and
/// smallest, for n points n + 4 for centroid and 4 n + 4 for ritter. They may have that many roundings, and no other
/// ball of doubles need exist. An infinite radius is right where no finite one is large enough.
/// No point at all: refused ("points", "at least 1 point"), NaN or infinity too ("points[0][1]" ..., "finite number").
///
/// In exact arithmetic every method is right. (3/2: Zarrabi-Zadeh and Chan 2006. In units of the smallest ball's radius
/// and seen from its center, a grown ball of center c and radius r has |c|^2 <= 1 - r^2 / 3: so has the first, and if r
/// grows to s by a point p, |p| <= 1, then |c|^2 becomes (s |c|^2 + (s - r) |p|^2) / (2 s - r) - s (s - r), which is
/// less than 1 - s^2 / 3 by 4/3 s (s - r)^2 / (2 s - r) at least. And |c| >= s - 1, as p is on its boundary. Together s
/// <= 3/2.)
///
/// Rounding (binary64, to nearest, u = 2^-53): a rounded ball may lose points: both center and radius are rounded, and
/// nothing is rounded up. So no input but the simplest has a guarantee, however far it is from degenerate: of box, a
/// coordinate of the center is off by u of it at most, unless the sum overflows, and 2^-1075. The squared distances D
/// and the root are off by factors (1 + u)^5 and (1 + u), so the radius is off from the least about the computed center
/// by 4u of it, unless D underflows or overflows. Nothing is decided: there is no margin.
template <class Real>
Sphere3<Real> bounding_sphere(const std::vector<Point3<Real>>& points, SphereMethod method) {
  using std::sqrt;
  const auto total = [&points](Real Point3<Real>::*axis) {
    Real sum = points[0].*axis;
    for (std::size_t i = 1; i < points.size(); ++i) sum = Real(sum + points[i].*axis);
    return sum;
  };
  switch (method) {
    case SphereMethod::box: {
      const auto [x, y, z] = ends_of_axes(points);
      const Point3<Real> min{points[x.first].x, points[y.first].y, points[z.first].z};
      return reaching_farthest(middle(min, {points[x.second].x, points[y.second].y, points[z.second].z}), points);
    }
    case SphereMethod::centroid: {
      const Real n = static_cast<Real>(static_cast<int>(points.size()));
      const Real x = total(&Point3<Real>::x), y = total(&Point3<Real>::y), z = total(&Point3<Real>::z);
      return reaching_farthest(Point3<Real>{Real(x / n), Real(y / n), Real(z / n)}, points);
    }
    case SphereMethod::ritter: return growing_ball(points);
    case SphereMethod::smallest: break;
  }
  std::vector<Point3<Real>> left = points, on;
  const SquaredBall<Real> ball = smallest_ball(left, left.size(), on);
  return {ball.center, Real(sqrt(ball.radius_squared))};
}

}  // namespace touchstone::reference
