// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

inline FirstContact<double> hit(double t) { return {HitRelation::hit, t}; }
inline const FirstContact<double> no_hit{HitRelation::never, std::nullopt};

}  // namespace touchstone::robust::kernel
