// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "geometry/space.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// The points on the boundary of the smallest ball, guessed in floating point: any answer is checked afterwards.
///
/// A ball around a few points grows by the point that is farthest from its center, until none is outside but by
/// roundings. The smallest ball of these few is found by Welzl's method, and each ball from the one with a point less
/// on its boundary: its center moves along what the new point adds to the flat of the others (Gaertner, 1999).
class SupportGuess {
 public:
  explicit SupportGuess(const std::vector<Point3d>& points) {
    push(points[0]);
    const Point3d* far = farthest(points);
    double before = -1;
    for (int left = 100; left > 0 && square_ > before && off(*far) > square_ * (1 + 0x1p-40); --left) {
      before = square_;
      const std::array<Point3d, 4> others = on_;
      const std::size_t count = size_;
      known_ = 0;
      push(*far);
      enclose(others, count);
      far = farthest(points);
    }
  }
  std::span<const Point3d> support() const { return {on_.data(), size_}; }

 private:
  double off(const Point3d& p) const {
    const Vector3d v = p - center_;
    return dot(v, v);
  }
  const Point3d* farthest(const std::vector<Point3d>& points) const {
    const Point3d* far = points.data();
    double most = -1;
    for (const Point3d& p : points) {
      const double square = off(p);
      if (square > most) most = square, far = &p;
    }
    return far;
  }
  void push(const Point3d& p) {
    stack_[known_] = p;
    if (known_ == 0) {
      steps_[0] = {p, {}, 0, 0};
    } else {
      const Vector3d q = p - stack_[0];
      Vector3d v = q;
      for (std::size_t i = 1; i < known_; ++i) v = v - dot(steps_[i].axis, q) * steps_[i].inverse * steps_[i].axis;
      const Step& last = steps_[known_ - 1];
      const Vector3d out = p - last.center;
      const double z = 2 * dot(v, v), e = dot(out, out) - last.square, f = e / z;
      steps_[known_] = {last.center + f * v, v, 2 / z, last.square + e * f / 2};
    }
    center_ = steps_[known_].center, square_ = steps_[known_].square;
    on_ = stack_, size_ = ++known_;
  }
  /// The smallest ball of the first `count` others with the known points on its boundary.
  void enclose(const std::array<Point3d, 4>& others, std::size_t count) {
    if (known_ == 4) return;
    for (std::size_t i = 0; i < count; ++i) {
      if (!(off(others[i]) > square_ * (1 + 0x1p-40))) continue;
      push(others[i]);
      enclose(others, i);
      --known_;
    }
  }

  struct Step {
    Point3d center;
    Vector3d axis;
    double inverse, square;
  };
  std::array<Point3d, 4> stack_, on_;
  std::array<Step, 4> steps_;
  std::size_t known_ = 0, size_ = 0;
  Point3d center_;
  double square_;
};

}  // namespace touchstone::robust::kernel
