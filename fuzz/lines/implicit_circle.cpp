// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lines/implicit_circle.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(implicit_circle)
