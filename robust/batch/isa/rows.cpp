// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/isa/rows.h"

#include <string>

namespace touchstone::robust::batch {

void refuse_row(std::size_t i, const InvalidInput& refused) {
  throw InvalidInput("questions[" + std::to_string(i) + "]." + refused.field(), refused.rule());
}

}  // namespace touchstone::robust::batch
