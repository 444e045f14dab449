// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lines/segment_segment.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(segment_segment)
