// SPDX-License-Identifier: Apache-2.0
#include <cfenv>

#include "robust/batch/isa/columns.h"
#include "robust/batch/isa/filters.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace touchstone::robust::batch::isa {
namespace {

/// True if results are rounded to nearest and neither results nor operands are flushed to zero.
bool plain_arithmetic() {
#if defined(__SSE2__)
  constexpr unsigned rounding = 0x6000, flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  return (_mm_getcsr() & (rounding | flush_to_zero | denormals_are_zero)) == 0;
#else
  return std::fegetround() == FE_TONEAREST;
#endif
}

}  // namespace

const Filters* filters_here(int at_most) {
  if (!plain_arithmetic()) return nullptr;
#if defined(__x86_64__)
  const bool of_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi");
  const bool of_avx512 = of_avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  if (at_most >= static_cast<int>(Instructions::avx512) && of_avx512) return &avx512_filters;
  if (at_most >= static_cast<int>(Instructions::avx2) && of_avx2) return &avx2_filters;
#endif
  return &portable_filters;
}

}  // namespace touchstone::robust::batch::isa
