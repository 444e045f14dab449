// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/enclosing_ball.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {
namespace {

using Gram = std::array<std::array<Integer, 3>, 3>;

Integer determinant(const Gram& g, std::size_t n) {
  if (n == 0) return 1;
  if (n == 1) return g[0][0];
  const auto minor = [&g](std::size_t i, std::size_t j) { return Integer(g[1][i] * g[2][j] - g[1][j] * g[2][i]); };
  if (n == 2) return Integer(g[0][0] * g[1][1] - g[0][1] * g[1][0]);
  return Integer(g[0][0] * minor(1, 2) - g[0][1] * minor(0, 2) + g[0][2] * minor(0, 1));
}

/// The ball whose center is a convex combination of points that are all equally far from it, with positive weights;
/// nullopt if there is none. With v the displacements from the first point to the others, the weights of these solve 2
/// v_i . v_j w = v_i . v_i, by Cramer's rule; the determinant is not negative, and 0 if they are affinely dependent.
std::optional<SmallestBall> balanced(const IntegerPoints& points, const std::vector<std::size_t>& support) {
  const std::size_t n = support.size() - 1;
  const IntegerPoint& first = points[support[0]];
  std::vector<Vector3<Integer>> v;
  for (std::size_t i = 1; i <= n; ++i) v.push_back(points[support[i]] - first);
  Gram gram;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) gram[i][j] = 2 * dot(v[i], v[j]);
  SmallestBall ball;
  ball.support = support;
  ball.d = determinant(gram, n);
  if (sgn(ball.d) == 0) return std::nullopt;
  Integer rest = ball.d;
  ball.weights.resize(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    Gram with = gram;
    for (std::size_t j = 0; j < n; ++j) with[j][i] = dot(v[j], v[j]);
    ball.weights[i + 1] = determinant(with, n);
    rest -= ball.weights[i + 1];
  }
  ball.weights[0] = rest;
  if (std::any_of(ball.weights.begin(), ball.weights.end(), [](const Integer& w) { return sgn(w) <= 0; }))
    return std::nullopt;
  ball.times = {0, 0, 0};
  for (std::size_t i = 0; i <= n; ++i) {
    const IntegerPoint& p = points[support[i]];
    ball.times.x += ball.weights[i] * p.x, ball.times.y += ball.weights[i] * p.y, ball.times.z += ball.weights[i] * p.z;
  }
  ball.square = ball.squared_distance(first);
  return ball;
}

/// The smallest ball of `held` and `more`, which is outside of the smallest of `held` and so in the support.
SmallestBall smallest_with(const IntegerPoints& points, const std::vector<std::size_t>& held, std::size_t more) {
  for (unsigned chosen = 0;; ++chosen) {
    std::vector<std::size_t> support{more};
    for (std::size_t i = 0; i < held.size(); ++i)
      if ((chosen >> i & 1) != 0) support.push_back(held[i]);
    if (support.size() > 4) continue;
    const auto ball = balanced(points, support);
    if (!ball) continue;
    const auto inside = [&](std::size_t i) { return ball->squared_distance(points[i]) <= ball->square; };
    if (std::all_of(held.begin(), held.end(), inside)) return *ball;
  }
}

Integer square_of(const Vector3<Integer>& v) { return dot(v, v); }

struct Rounded {
  Integer value;
  bool exact;
};
Rounded root_above(const Integer& square) {
  Integer root, rest;
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), square.get_mpz_t());
  const bool exact = sgn(rest) == 0;
  return {Integer(exact ? root : root + 1), exact};
}

}  // namespace

Integer IntegerBall::squared_distance(const Point3<Integer>& p) const {
  return square_of({Integer(p.x * d - times.x), Integer(p.y * d - times.y), Integer(p.z * d - times.z)});
}

std::size_t IntegerBall::farthest(const IntegerPoints& points) const {
  std::size_t found = 0;
  Integer greatest = squared_distance(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    Integer distance = squared_distance(points[i]);
    if (distance > greatest) found = i, greatest = std::move(distance);
  }
  return found;
}

IntegerBall reaching_farthest(const Point3<Integer>& times, const Integer& d, const IntegerPoints& points) {
  IntegerBall ball{times, d, 0};
  ball.square = ball.squared_distance(points[ball.farthest(points)]);
  return ball;
}

SmallestBall smallest_ball(const IntegerPoints& points) {
  SmallestBall ball = *balanced(points, {0});
  for (;;) {  // the radius grows, and there are finitely many supports
    const std::size_t farthest = ball.farthest(points);
    if (ball.squared_distance(points[farthest]) <= ball.square) return ball;
    ball = smallest_with(points, ball.support, farthest);
  }
}

GrowingBall growing_ball(const IntegerPoints& points, unsigned below) {
  const IntegerPoint *a = points.data(), *b = a;
  Integer width = 0;
  for (const auto axis : {&IntegerPoint::x, &IntegerPoint::y, &IntegerPoint::z}) {
    const auto ascending = [axis](const IntegerPoint& p, const IntegerPoint& q) { return p.*axis < q.*axis; };
    const IntegerPoint& low = *std::min_element(points.begin(), points.end(), ascending);
    const IntegerPoint& high = *std::max_element(points.begin(), points.end(), ascending);
    const Integer square = square_of(high - low);
    if (square > width) a = &low, b = &high, width = square;
  }
  const auto finer = [](const Integer& n, unsigned bits) { return Integer(n << bits); };
  const auto place = [&](const IntegerPoint& p) -> IntegerPoint {
    return {finer(p.x, below), finer(p.y, below), finer(p.z, below)};
  };
  const Rounded wide = root_above(finer(width, 2 * below - 2));
  GrowingBall ball{{finer(a->x + b->x, below - 1), finer(a->y + b->y, below - 1), finer(a->z + b->z, below - 1)},
                   wide.value};
  for (const IntegerPoint& point : points) {
    const IntegerPoint p = place(point);
    const Vector3<Integer> displacement = p - ball.center;
    const Integer square = square_of(displacement);
    if (square <= ball.radius * ball.radius) continue;
    const Integer distance = root_above(square).value, step(distance - ball.radius), twice(2 * distance);
    bool exact = true;
    const auto moved = [&](const Integer& from, const Integer& along) {
      const Integer numerator(along * step);
      exact = exact && mpz_divisible_p(numerator.get_mpz_t(), twice.get_mpz_t()) != 0;
      return Integer(from + numerator / twice);
    };
    ball.center = {moved(ball.center.x, displacement.x), moved(ball.center.y, displacement.y),
                   moved(ball.center.z, displacement.z)};
    // Half a unit for the division by 2; the center is off by less than a unit on each axis, 2 in all.
    ball.radius = (ball.radius + distance + 1) / 2 + (exact ? 0 : 2);
  }
  return ball;
}

}  // namespace touchstone::oracle
