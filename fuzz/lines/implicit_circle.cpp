// SPDX-License-Identifier: Apache-2.0
#include "audit/catalogue/lines/implicit_circle.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(implicit_circle)
