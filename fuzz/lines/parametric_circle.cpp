// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lines/parametric_circle.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(parametric_circle)
