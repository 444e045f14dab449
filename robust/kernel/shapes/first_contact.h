// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/filters/ordered_bits.h"

namespace touchstone::robust::kernel {

inline FirstContact<double> hit(double t) { return {HitRelation::hit, t}; }
inline const FirstContact<double> no_hit{HitRelation::never, std::nullopt};

/// Reads times as bits: a subnormal may be read as zero.
inline const FirstContact<double>& earlier(const FirstContact<double>& a, const FirstContact<double>& b) {
  if (!a.t || !b.t) return a.t ? a : b;
  return ordered_bits(*b.t) < ordered_bits(*a.t) ? b : a;
}

}  // namespace touchstone::robust::kernel
