// SPDX-License-Identifier: Apache-2.0
#include "audit/limb_memory.h"

namespace {

// The sanitizer's allocator would take most of the time of a fuzz target, and could watch nothing there: GMP is not
// instrumented, and it alone touches its limbs.
[[maybe_unused]] const bool before_any_input = (touchstone::audit::use_limb_memory(), true);

}  // namespace
