// SPDX-License-Identifier: Apache-2.0
#include "my_engine.h"

TOUCHSTONE_ENGINE_MAIN(MyEngine)
