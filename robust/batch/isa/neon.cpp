// SPDX-License-Identifier: Apache-2.0
#if defined(__aarch64__)
#define TOUCHSTONE_LANES 2
#include "robust/batch/isa/table.h"

namespace touchstone::robust::batch::isa {

const Filters neon_filters = filters_of_this_unit;

}  // namespace touchstone::robust::batch::isa
#endif
