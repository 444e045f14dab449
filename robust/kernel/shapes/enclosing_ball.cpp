// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/enclosing_ball.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "robust/kernel/enclosed/enclosed_ball.h"
#include "robust/kernel/integers/rounding.h"

namespace touchstone::robust::kernel {
namespace {

using IntegerPoint = Point3<mpz_class>;
using Displacement = Vector3<mpz_class>;

constexpr double greatest_double = std::numeric_limits<double>::max();

/// The least exponent of any set bit.
int unit_of(const std::vector<Point3d>& points) {
  int low = 0;
  for (const Point3d& p : points)
    for (const double x : {p.x, p.y, p.z}) {
      const Decoded part = decode(x);
      if (part.magnitude != 0) low = std::min(low, part.exponent + std::countr_zero(part.magnitude));
    }
  return low;
}

/// x in units of 2^unit, of which it is a multiple.
mpz_class integer(double x, int unit) {
  const Decoded part = decode(x);
  if (part.magnitude == 0) return 0;
  const int zeros = std::countr_zero(part.magnitude);
  return scaled(Decoded{part.magnitude >> zeros, 0, part.negative}, part.exponent + zeros - unit);
}
IntegerPoint integer(const Point3d& p, int unit) {
  return {integer(p.x, unit), integer(p.y, unit), integer(p.z, unit)};
}

/// The smallest ball with these affinely independent points, up to four, on its boundary: its center is from + n / d, d
/// > 0, and its radius |n| / d. By the formulas of reference/volumes/bounding_sphere.h, which the deck's method needs
/// too; here they are exact.
struct BallThrough {
  IntegerPoint from;
  Displacement n;
  mpz_class d;

  explicit BallThrough(const std::vector<IntegerPoint>& on) : from(on[0]), n{0, 0, 0}, d(1) {
    if (on.size() == 1) return;
    const Displacement u = on[1] - from;
    if (on.size() == 2) {
      n = u, d = 2;
      return;
    }
    const Displacement v = on[2] - from, normal = cross(u, v);
    if (on.size() == 3) {
      n = cross(dot(u, u) * v - dot(v, v) * u, normal), d = 2 * dot(normal, normal);
      return;
    }
    const Displacement w = on[3] - from;
    n = dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * normal, d = 2 * dot(normal, w);
    if (sgn(d) < 0) n = mpz_class(-1) * n, d = -d;
  }

  /// |q - center|^2 > radius^2, multiplied by d.
  bool leaves_out(const IntegerPoint& q) const {
    const Displacement displacement = q - from;
    return d * dot(displacement, displacement) > 2 * dot(displacement, n);
  }
  double rounded(const mpz_class& start, const mpz_class& step, int unit) const {
    return round_quotient(mpz_class(start * d + step), d, unit);
  }
  Point3d center(int unit) const {
    return {rounded(from.x, n.x, unit), rounded(from.y, n.y, unit), rounded(from.z, n.z, unit)};
  }
};

/// Welzl's algorithm with points moved to the front: a point outside of a ball lies on the boundary of the next one.
/// The recursion is as deep as there are points on the boundary: at most four.
class SmallestBall {
 public:
  explicit SmallestBall(const std::vector<Point3d>& points)
      : points_(points), order_(points.size()), unit_(unit_of(points)) {
    // A pseudorandom order, unrelated to that of the points: points sorted along a line would take quadratic time. The
    // order is fixed, so that the cost of an answer is, too.
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
    std::uint64_t state = 1;
    for (std::size_t i = order_.size(); i > 1; --i) {
      state = state * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX
      std::swap(order_[i - 1], order_[(state >> 33) % i]);
    }
    with(order_[0], 1);
    enclose(order_.size());
  }
  Point3d center() const { return center_; }

 private:
  /// The ball of the first `count` points with all of `on_` on its boundary.
  void enclose(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t p = order_[i];
      if (!leaves_out(p)) continue;
      with(p, i);
      std::rotate(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(i),
                  order_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
  }
  void with(std::size_t p, std::size_t count) {
    on_.push_back(integer(points_[p], unit_));
    set(BallThrough(on_));
    if (on_.size() < 4) enclose(count);
    on_.pop_back();
  }

  void set(BallThrough ball) {
    ball_ = std::move(ball);
    center_ = ball_->center(unit_);
    inner_ = {center_, round_square_root(dot(ball_->n, ball_->n), mpz_class(ball_->d * ball_->d), 2 * unit_)};
  }
  bool leaves_out(std::size_t p) const {
    return !inner_.holds(points_[p]) && ball_->leaves_out(integer(points_[p], unit_));
  }

  const std::vector<Point3d>& points_;
  std::vector<std::size_t> order_;
  int unit_;
  std::vector<IntegerPoint> on_;
  std::optional<BallThrough> ball_;
  Point3d center_{};
  InnerBall inner_;
};

}  // namespace

double greatest_coordinate(const std::vector<Point3d>& points) {
  double greatest = 0;
  for (const Point3d& p : points)
    for (const double x : {p.x, p.y, p.z}) greatest = std::max(greatest, __builtin_fabs(x));
  return greatest;
}

double least_radius(const Point3d& center, const std::vector<Point3d>& points) {
  double greatest = 0;
  for (const Point3d& p : points) greatest = std::max(greatest, squared_distance(center, p));
  // The points that may be farthest: exact distances are off by 2^-50 of the computed ones.
  const double nearly = std::min(greatest, greatest_double) * (1 - 0x1p-48) - 0x1p-1060;
  std::vector<Point3d> far{center};
  for (const Point3d& p : points)
    if (!(squared_distance(center, p) < nearly)) far.push_back(p);
  if (far.size() <= 5)
    if (const auto radius = enclosed_radius(center, std::span(far).subspan(1))) return *radius;
  const int unit = unit_of(far);
  const IntegerPoint from = integer(center, unit);
  mpz_class square = 0;
  for (const Point3d& p : far) {
    const Displacement displacement = integer(p, unit) - from;
    square = std::max(square, dot(displacement, displacement));
  }
  const double radius = round_square_root(square, mpz_class(1), 2 * unit);
  if (!(radius <= greatest_double)) return radius;
  const Decoded root = decode(radius);  // a multiple of 2^root.exponent; the greatest is finite, too
  mpz_class rounded = scaled(Decoded{root.magnitude, 0, false}, 0), exact = square;
  rounded *= rounded;
  const int more = 2 * (root.exponent - unit);
  if (more > 0) rounded <<= static_cast<std::uint64_t>(more);
  else exact <<= static_cast<std::uint64_t>(-more);
  return rounded < exact ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(radius) + 1) : radius;
}

Sphere3d smallest_ball(const std::vector<Point3d>& points) {
  if (const auto certain = enclosed_smallest_ball(points)) return *certain;
  const Point3d center = SmallestBall(points).center();
  return {center, least_radius(center, points)};
}

}  // namespace touchstone::robust::kernel
