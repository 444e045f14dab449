// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/strict_math.h"

/// Vectors of 16 bytes, whose arithmetic the compiler knows for every processor.
namespace touchstone::robust::kernel::processor {

__extension__ typedef double TwoNumbers __attribute__((vector_size(16)));
__extension__ typedef long long TwoBits __attribute__((vector_size(16)));
__extension__ typedef int FourIntegers __attribute__((vector_size(16)));
__extension__ typedef float FourFloats __attribute__((vector_size(16)));

}  // namespace touchstone::robust::kernel::processor
