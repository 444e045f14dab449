// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lines/orientation.h"

#include "fuzz/driver/fuzz_target.h"

TOUCHSTONE_FUZZ(orientation)
