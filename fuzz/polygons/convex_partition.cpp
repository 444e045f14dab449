// SPDX-License-Identifier: Apache-2.0
#include "catalogue/polygons/convex_partition.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(convex_partition)
