// SPDX-License-Identifier: Apache-2.0
#include "audit/catalogue/lines/parametric_circle.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(parametric_circle)
