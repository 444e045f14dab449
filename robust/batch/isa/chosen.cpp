// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/isa/columns.h"
#include "robust/batch/isa/filters.h"
#include "robust/kernel/filters/processor.h"

#if defined(__aarch64__) && defined(__linux__)
#include <sys/auxv.h>
#include <sys/prctl.h>
#endif

namespace touchstone::robust::batch::isa {

#if defined(__aarch64__)
namespace {

/// Returns whether the processor has SVE and this thread's registers have the size for which sve.cpp is compiled.
bool registers_of_256_bits() {
#if defined(__linux__)
  if ((getauxval(AT_HWCAP) & HWCAP_SVE) == 0) return false;
  return (prctl(PR_SVE_GET_VL) & PR_SVE_VL_LEN_MASK) == 32;
#else
  return false;
#endif
}

}  // namespace
#endif

const Filters* filters_here([[maybe_unused]] int at_most) {
  if (!kernel::processor::plain_arithmetic()) return nullptr;
#if defined(__x86_64__)
  const bool of_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi");
  const bool of_avx512 = of_avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  if (at_most >= static_cast<int>(Instructions::avx512) && of_avx512) return &avx512_filters;
  if (at_most >= static_cast<int>(Instructions::avx2) && of_avx2) return &avx2_filters;
#elif defined(__aarch64__)
  if (at_most >= static_cast<int>(Instructions::sve) && registers_of_256_bits()) return &sve_filters;
  if (at_most >= static_cast<int>(Instructions::neon)) return &neon_filters;
#endif
  return &portable_filters;
}

}  // namespace touchstone::robust::batch::isa
