// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/validation.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

using validation::all_finite, validation::valid;

}  // namespace touchstone::robust::kernel
