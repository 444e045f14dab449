// SPDX-License-Identifier: Apache-2.0
#if defined(__AVX2__) && defined(__FMA__)
#define TOUCHSTONE_LANES 4
#elif defined(__SSE2__)
#define TOUCHSTONE_LANES 2
#endif
#ifdef TOUCHSTONE_LANES
#include "robust/batch/isa/table.h"

namespace touchstone::robust::batch::isa {

const Filters avx2_filters = filters_of_this_unit;

}  // namespace touchstone::robust::batch::isa
#endif
