// SPDX-License-Identifier: Apache-2.0
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define TOUCHSTONE_LANES 8
#elif defined(__SSE2__)
#define TOUCHSTONE_LANES 2
#endif
#ifdef TOUCHSTONE_LANES
#include "robust/batch/isa/table.h"

namespace touchstone::robust::batch::isa {

const Filters avx512_filters = filters_of_this_unit;

}  // namespace touchstone::robust::batch::isa
#endif
