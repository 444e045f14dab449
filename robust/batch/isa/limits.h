// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::batch {

/// The instructions that a call may use. It uses the widest of these that the processor has; the answers are the same.
/// On 64-bit Arm NEON takes the place of AVX2, and SVE with registers of 256 bits that of AVX-512.
enum class Instructions { portable, avx2, avx512, neon = avx2, sve = avx512 };

/// Limits of a call: instructions, and a number of threads, 0 for as many as the machine runs at once. The answers are
/// the same.
struct Limits {
  Instructions at_most = Instructions::avx512;
  std::size_t threads = 1;

  Limits() = default;
  Limits(Instructions at_most, std::size_t threads = 1) : at_most(at_most), threads(threads) {}
};

}  // namespace touchstone::robust::batch
