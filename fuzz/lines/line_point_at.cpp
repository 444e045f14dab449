// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lines/line_point_at.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(line_point_at)
