// SPDX-License-Identifier: Apache-2.0
#include "catalogue/polygons/polygon_polygon.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(polygon_polygon)
