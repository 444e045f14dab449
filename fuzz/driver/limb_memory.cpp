// SPDX-License-Identifier: Apache-2.0
#include "audit/limb_memory.h"

namespace {

// The sanitizer's allocator would take most of a fuzz target's time and could detect nothing: GMP is not instrumented,
// and only GMP touches its limbs.
[[maybe_unused]] const bool before_any_input = (touchstone::audit::use_limb_memory(), true);

}  // namespace
