// SPDX-License-Identifier: Apache-2.0
#include "catalogue/polygons/interior_angles.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(interior_angles)
