// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/decode.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point lies inside of a circle, on it (`boundary`) or outside.
///
/// `boundary` means exactly on the circle; a circle of radius 0 is its center, which is all boundary. Right for all
/// finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so does a negative radius ("radius >= 0"). Contract: reference/lines/implicit_circle.h.
inline Location implicit_circle(const Circle2d& circle, const Point2d& point);

namespace stages {

struct implicit_circle : Filtered<implicit_circle, decltype(robust::implicit_circle)> {
  static Perhaps<Location> filter(const Circle2d& circle, const Point2d& point) {
    if (kernel::sign_bit(circle.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
    return filters::by_sign(filters::circle(point - circle.center, circle.radius), Location::inside, Location::outside);
  }
  static Partial lattice;
  static Total exact;
  static Staged past_filter;
};

}  // namespace stages

inline Location implicit_circle(const Circle2d& circle, const Point2d& point) {
  return stages::implicit_circle::ask(circle, point).answer;
}

}  // namespace touchstone::robust
