// SPDX-License-Identifier: Apache-2.0
#include "catalogue/planes/point_plane.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(point_plane)
