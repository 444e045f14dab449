// SPDX-License-Identifier: Apache-2.0
#define TOUCHSTONE_LANES 4
#include "bench/isa/naive.h"

namespace touchstone::robust::batch::isa {

const NaiveLoops avx2_loops = loops_of_this_unit;

}  // namespace touchstone::robust::batch::isa
