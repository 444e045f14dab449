// SPDX-License-Identifier: Apache-2.0
#include "catalogue/polygons/point_in_polygon.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(point_in_polygon)
