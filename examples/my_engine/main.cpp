// SPDX-License-Identifier: Apache-2.0
#include <touchstone/program/engine_main.h>

#include "my_engine.h"

TOUCHSTONE_ENGINE_MAIN(MyEngine)
