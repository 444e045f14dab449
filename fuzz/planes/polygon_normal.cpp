// SPDX-License-Identifier: Apache-2.0
#include "catalogue/planes/polygon_normal.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(polygon_normal)
