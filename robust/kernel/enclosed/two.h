// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/points.h"
#include "robust/kernel/filters/float_format.h"
#include "robust/kernel/filters/processor.h"

namespace touchstone::robust::kernel {

/// Two doubles that are processed together, by one instruction for both if there is one. A comparison returns true if
/// it holds for both.
struct Two {
  using Lanes = processor::TwoNumbers;
  using Bits = processor::TwoBits;

  Lanes lanes;

  Two() : lanes{0, 0} {}
  Two(double first, double second) : lanes{first, second} {}
  explicit Two(double both) : lanes{both, both} {}
  explicit Two(Lanes both) : lanes(both) {}
  explicit Two(const Point2d& p) : lanes{p.x, p.y} {}
  explicit Two(const Vector2d& v) : lanes{v.x, v.y} {}

  double first() const { return lanes[0]; }
  double second() const { return lanes[1]; }
  Two swapped() const { return Two(second(), first()); }

  friend Two operator+(Two a, Two b) { return Two(a.lanes + b.lanes); }
  friend Two operator-(Two a, Two b) { return Two(a.lanes - b.lanes); }
  friend Two operator*(Two a, Two b) { return Two(a.lanes * b.lanes); }
  friend Two operator/(Two a, Two b) { return Two(a.lanes / b.lanes); }
  friend Two operator-(Two a) { return Two(-a.lanes); }
  friend bool operator>=(Two a, Two b) { return processor::both(a.lanes >= b.lanes); }
  friend bool operator<=(Two a, Two b) { return processor::both(a.lanes <= b.lanes); }
};

/// The first numbers of a and b, and the second ones.
inline Two firsts(Two a, Two b) { return Two(a.first(), b.first()); }
inline Two seconds(Two a, Two b) { return Two(a.second(), b.second()); }

}  // namespace touchstone::robust::kernel

namespace touchstone::robust::filters {

template <>
struct FloatFormat<kernel::Two> : FloatFormat<double> {
  using Two = kernel::Two;
  static Two above(double c) { return Two(c); }
  static Two magnitude(Two x) {
    return Two(reinterpret_cast<Two::Lanes>(reinterpret_cast<Two::Bits>(x.lanes) & 0x7fffffffffffffff));
  }
  static Two head(Two x) {
    return Two(reinterpret_cast<Two::Lanes>(reinterpret_cast<Two::Bits>(x.lanes) & ~((1LL << 27) - 1)));
  }
  static Two square_root(Two x) { return {__builtin_sqrt(x.first()), __builtin_sqrt(x.second())}; }
};

}  // namespace touchstone::robust::filters
