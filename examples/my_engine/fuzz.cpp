// SPDX-License-Identifier: Apache-2.0
#include <touchstone/audit/engines/fuzz.h>

#include "my_engine.h"

TOUCHSTONE_ENGINE_FUZZ(MyEngine, segment_segment)
