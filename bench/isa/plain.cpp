// SPDX-License-Identifier: Apache-2.0
#define TOUCHSTONE_LANES 1
#include "bench/isa/naive.h"

namespace touchstone::robust::batch::isa {

const NaiveLoops plain_loops = loops_of_this_unit;

}  // namespace touchstone::robust::batch::isa
