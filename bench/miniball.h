// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "catalogue/catalogue.h"

/// The smallest ball around points in floating point, by the method of the paper: Gaertner, Fast and robust smallest
/// enclosing balls, ESA 1999. Welzl's method with points moved to the front, asked about the point that is farthest out
/// until none is outside. Neither the center nor the radius is exact: points may be outside by roundings.
namespace touchstone::bench {

class Miniball {
 public:
  explicit Miniball(const std::vector<Point3d>& points) : points_(points), order_(points.size()) {
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
    enclose(1);
    std::size_t inside = support_;  // the first so many points are inside
    for (double before = -1; square_ > before;) {
      before = square_;
      const std::size_t far = farthest(inside);
      if (far == order_.size() || !(excess(points_[order_[far]]) > 0) || !push(points_[order_[far]])) break;
      inside = support_ + 1;
      enclose(support_), --on_;
      move_to_front(far);
    }
  }
  Sphere3d ball() const { return {{center_[0], center_[1], center_[2]}, std::sqrt(square_)}; }

 private:
  using Vector = std::array<double, 3>;

  static double dot(const Vector& v, const Vector& w) { return v[0] * w[0] + v[1] * w[1] + v[2] * w[2]; }
  static Vector of(const Point3d& p) { return {p.x, p.y, p.z}; }
  static Vector between(const Vector& p, const Vector& q) { return {q[0] - p[0], q[1] - p[1], q[2] - p[2]}; }

  double excess(const Point3d& p) const {
    const Vector v = between(center_, of(p));
    return dot(v, v) - square_;
  }
  std::size_t farthest(std::size_t from) const {
    std::size_t far = order_.size();
    double most = 0;
    for (std::size_t i = from; i < order_.size(); ++i) {
      const Vector v = between(center_, of(points_[order_[i]]));
      const double square = dot(v, v);
      if (square > most) most = square, far = i;
    }
    return far;
  }
  /// A point that the support has gained.
  void move_to_front(std::size_t i) {
    ++support_;
    std::rotate(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(i),
                order_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }

  /// Puts a point outside of the ball on the boundary of the next one; false if it is nearly dependent on those there.
  bool push(const Point3d& p) {
    if (on_ == 0) {
      first_ = of(p), centers_[0] = center_ = first_, squares_[0] = square_ = 0, on_ = 1;
      return true;
    }
    const std::size_t m = on_;
    const Vector q = between(first_, of(p));
    Vector v = q;
    for (std::size_t i = 1; i < m; ++i) {
      const double share = dot(axes_[i], q) * inverse_[i];
      for (std::size_t k = 0; k < 3; ++k) v[k] -= share * axes_[i][k];
    }
    const double z = 2 * dot(v, v);
    if (z < 1e-32 * square_) return false;
    const Vector out = between(centers_[m - 1], of(p));
    const double e = dot(out, out) - squares_[m - 1], f = e / z;
    axes_[m] = v, inverse_[m] = 2 / z;
    for (std::size_t k = 0; k < 3; ++k) centers_[m][k] = centers_[m - 1][k] + f * v[k];
    squares_[m] = squares_[m - 1] + e * f / 2;
    center_ = centers_[m], square_ = squares_[m], on_ = m + 1;
    return true;
  }
  /// The ball of the first `count` points with those that were pushed on its boundary.
  void enclose(std::size_t count) {
    support_ = 0;
    if (on_ == 4) return;
    for (std::size_t i = 0; i < count; ++i) {
      const Point3d& p = points_[order_[i]];
      if (excess(p) > 0 && push(p)) {
        enclose(i), --on_;
        move_to_front(i);
      }
    }
  }

  const std::vector<Point3d>& points_;
  std::vector<std::size_t> order_;
  std::size_t on_ = 0, support_ = 0;
  Vector first_{}, center_{};
  double square_ = -1;
  std::array<Vector, 4> axes_{}, centers_{};
  std::array<double, 4> inverse_{}, squares_{};
};

/// - answer(question...): a full answer by a method that promises no correct rounding.
/// - right(answer, exact): whether it is right but for roundings.
template <class Row>
struct AnswerPeer;

template <>
struct AnswerPeer<catalogue::rows::bounding_sphere> {
  static constexpr const char* name = "miniball";
  static Sphere3d answer(const std::vector<Point3d>& points, const std::optional<SphereMethod>&) {
    return Miniball(points).ball();
  }
  static bool right(const Sphere3d& ball, const Sphere3d& exact) {
    return std::fabs(ball.radius - exact.radius) <= 0x1p-30 * exact.radius;
  }
};

}  // namespace touchstone::bench
