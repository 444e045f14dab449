// SPDX-License-Identifier: Apache-2.0
// For registers of 256 bits; those of 128 are NEON's.
#if defined(__ARM_FEATURE_SVE_BITS) && __ARM_FEATURE_SVE_BITS == 256
#define TOUCHSTONE_LANES 4
#elif defined(__aarch64__)
#define TOUCHSTONE_LANES 2  // this compiler was not asked for SVE: NEON
#endif
#ifdef TOUCHSTONE_LANES
#include "robust/batch/isa/table.h"

namespace touchstone::robust::batch::isa {

const Filters sve_filters = filters_of_this_unit;

}  // namespace touchstone::robust::batch::isa
#endif
