// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/enclosed/enclosed.h"

/// v + t n, with one bound for t and for all later steps, including the rounding test; the letters are those of
/// enclosed.h.
namespace touchstone::robust::kernel {

/// A number t is head + tail, off by at most error minus the cost of `along`.
///
/// Let g be a bound of the head, and the tail at most 2.4 T g. The product of t's and n's heads is exact. In units of E
/// g |n|: n's factors are off by 1; the head times n's tail rounds by 1, the tail times n by 2.4, their sum by 3.4;
/// adding it to what two_sum leaves by 3.4 and u^2 |v|; the ends of the enclosure by 3.4 and u^2 |v| more. Together
/// 14.6, and E |v| is plenty: an error of 59/4 E g and what t itself is off by is enough.
template <class Float>
struct Share {
  Float head, tail, error;
};

/// An exact number.
template <class Float>
[[gnu::always_inline]] inline Share<Float> share(const Float& t) {
  using Format = filters::FloatFormat<Float>;
  const Factor<Float> x = factor(t);
  return {x.head, x.tail, Format::above(16 * cut<Float>) * Format::magnitude(t)};
}

/// v + t n. Unlike in enclosed.h, the error also holds for the rounded ends of the enclosure.
template <class Float>
[[gnu::always_inline]] inline Enclosed<Float> along(const Float& v, const Share<Float>& t, const Factor<Float>& n) {
  using Format = filters::FloatFormat<Float>;
  const Pair<Float> sum = two_sum(t.head * n.head, v);
  const Float low = sum.low + (t.head * n.tail + t.tail * n.whole);
  const Float margin = t.error * Format::magnitude(n.whole) + Format::above(cut<Float>) * Format::magnitude(v);
  return {sum.high, low, margin};
}

/// The same, rounded; n is exact.
template <class Float>
[[gnu::always_inline]] inline std::optional<Float> enclosed_push(const Float& v, const Share<Float>& t,
                                                                 const Factor<Float>& n) {
  const Enclosed<Float> x = along(v, t, n);
  const Float above = x.high + (x.low + x.error), below = x.high + (x.low - x.error);
  if (!(above <= below)) return std::nullopt;
  return above + Float();  // -0 + 0 is +0
}

}  // namespace touchstone::robust::kernel
