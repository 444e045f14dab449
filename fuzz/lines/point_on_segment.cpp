// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lines/point_on_segment.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(point_on_segment)
