// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/enclosed/enclosed.h"
#include "robust/kernel/filters/sized.h"

/// Enclosed numbers that need not be settled: a result of cancellation stays a number, with an error as great as
/// itself.
namespace touchstone::robust::kernel {

struct Loose : Enclosed<double> {
  Loose(const Enclosed<double>& x) : Enclosed(x) {}
  explicit Loose(double x) : Enclosed{x, 0, 0} {}
  Loose(const Pair<double>& x) : Enclosed{x.high, x.low, 0} {}
};

inline Loose operator+(const Loose& x, const Loose& y) {
  return static_cast<const Enclosed<double>&>(x) + static_cast<const Enclosed<double>&>(y);
}
inline Loose operator-(const Loose& x) { return -static_cast<const Enclosed<double>&>(x); }
inline Loose operator-(const Loose& x, const Loose& y) { return x + -y; }

inline Loose operator*(const Loose& x, const Loose& y) {
  return times(static_cast<const Enclosed<double>&>(x), static_cast<const Enclosed<double>&>(y));
}

/// The same number with its high part rounded, after cancellation.
inline Loose ordered(const Loose& x) {
  const Pair<double> pair = in_order(static_cast<const Enclosed<double>&>(x));
  return Enclosed<double>{pair.high, pair.low, x.error};
}

/// Its sign is known, and is not 0.
inline bool certain(const Loose& x) { return x.settled() && x.high != 0; }
/// It is exactly 0.
inline bool none_of(const Loose& x) { return x.high == 0 && x.low == 0 && x.error == 0; }

/// q - p
inline filters::Triple<Loose> loose_between(const Point3d& p, const Point3d& q) {
  return {difference(q.x, p.x), difference(q.y, p.y), difference(q.z, p.z)};
}
inline filters::Triple<Loose> loose(const Vector3d& v) { return {Loose(v.x), Loose(v.y), Loose(v.z)}; }

/// from + t v, rounded.
inline std::optional<Point3d> rounded_along(const Point3d& from, const Loose& t, const filters::Triple<Loose>& v) {
  const auto x = rounded(Loose(from.x) + t * v.x), y = rounded(Loose(from.y) + t * v.y),
             z = rounded(Loose(from.z) + t * v.z);
  if (!x || !y || !z) return std::nullopt;
  return Point3d{*x, *y, *z};
}

}  // namespace touchstone::robust::kernel
