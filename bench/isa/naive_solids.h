// SPDX-License-Identifier: Apache-2.0
// A unit for each instruction set includes this, with TOUCHSTONE_LANES of its own.
#pragma once

#include "bench/isa/naive_space.h"

/// The formulas that one writes for capsules and oriented boxes if rounding does not matter (naive.h).
namespace touchstone::robust::batch::isa {
namespace {

Lanes clamped(Lanes t, double from) { return greater(lesser(t, same(1)), same(from)); }

/// For half axes at right angles.
struct NaiveSphereObb {
  static constexpr std::size_t columns = 16;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask of(const Lanes* c) {
    const Arrow way = Arrow(c) - Arrow(c + 4);
    Arrow rest = way;
    for (std::size_t k = 7; k < 16; k += 3) {
      const Arrow axis(c + k);
      rest = rest - clamped(dot(way, axis) / dot(axis, axis), -1) * axis;
    }
    return above(dot(rest, rest), c[3] * c[3]);
  }
};

/// Ericson, Real-Time Collision Detection, 5.1.9.
struct NaiveCapsules {
  static constexpr std::size_t columns = 14;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask of(const Lanes* n) {
    const Arrow p(n), q(n + 7), d1 = Arrow(n + 3) - p, d2 = Arrow(n + 10) - q, r = p - q;
    const Lanes a = dot(d1, d1), b = dot(d1, d2), c = dot(d1, r), e = dot(d2, d2), f = dot(d2, r);
    const Lanes first = clamped((b * f - c * e) / (a * e - b * b), 0), t = clamped((b * first + f) / e, 0),
                s = clamped((b * t - c) / a, 0);
    const Arrow rest = r - (same(-1) * s) * d1 - t * d2;
    const Lanes reach = n[6] + n[13];
    return above(dot(rest, rest), reach * reach);
  }
};

/// Fifteen axes.
struct NaiveObbs {
  static constexpr std::size_t columns = 24;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask of(const Lanes* n) {
    const Arrow way = Arrow(n + 12) - Arrow(n);
    const Arrow edges[] = {Arrow(n + 3), Arrow(n + 6), Arrow(n + 9), Arrow(n + 15), Arrow(n + 18), Arrow(n + 21)};
    Mask apart = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = i + 1; j < 6; ++j) {
        const Arrow axis = cross(edges[i], edges[j]);
        Lanes reach = same(0);
        for (std::size_t k = 0; k < 6; ++k)
          if (k != i && k != j) reach = reach + magnitude(dot(axis, edges[k]));
        apart |= above(magnitude(dot(axis, way)), reach);
      }
      if ((apart & all_lanes) == all_lanes) break;
    }
    return apart;
  }
};

}  // namespace
}  // namespace touchstone::robust::batch::isa
