// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lines/ray_segment.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(ray_segment)
