// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// For operations: what is handed over is known to be valid.
struct Validated {
  explicit Validated() = default;
};

}  // namespace touchstone::robust
