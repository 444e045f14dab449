// SPDX-License-Identifier: Apache-2.0
#include "audit/limb_memory.h"

namespace touchstone::proptests {
namespace {

[[maybe_unused]] const bool before_any_test = (audit::use_limb_memory(), true);

}  // namespace
}  // namespace touchstone::proptests
