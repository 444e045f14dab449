// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lines/explicit_line.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(explicit_line)
