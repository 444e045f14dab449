// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::audit {

/// From now on GMP takes its memory from free lists of each thread, which is a sixth faster where most of the time goes
/// into exact numbers, and throws std::bad_alloc where there is none, instead of ending the program. For the whole
/// process and until it ends; numbers that exist already may be changed and released as before.
void use_limb_memory();

}  // namespace touchstone::audit
