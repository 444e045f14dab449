// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::audit {

/// From now on GMP takes its memory from free lists of each thread, which is a sixth faster if most of the time goes
/// into exact numbers, and throws std::bad_alloc if there is none, instead of ending the program. Applies to the entire
/// process until it ends; existing numbers may be changed and released as before.
void use_limb_memory();

}  // namespace touchstone::audit
