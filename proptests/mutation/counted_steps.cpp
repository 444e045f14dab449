// SPDX-License-Identifier: Apache-2.0
// The callbacks of sanitizer coverage, for programs without libFuzzer: each comparison of integers in what is compiled
// with them is a step.
#include <cstdint>

namespace touchstone::proptests {
std::uint64_t steps_counted = 0;
}

namespace {
void count() { ++touchstone::proptests::steps_counted; }
}  // namespace

extern "C" {
void __sanitizer_cov_8bit_counters_init(char*, char*) {}
void __sanitizer_cov_trace_cmp1(std::uint8_t, std::uint8_t) { count(); }
void __sanitizer_cov_trace_cmp2(std::uint16_t, std::uint16_t) { count(); }
void __sanitizer_cov_trace_cmp4(std::uint32_t, std::uint32_t) { count(); }
void __sanitizer_cov_trace_cmp8(std::uint64_t, std::uint64_t) { count(); }
void __sanitizer_cov_trace_const_cmp1(std::uint8_t, std::uint8_t) { count(); }
void __sanitizer_cov_trace_const_cmp2(std::uint16_t, std::uint16_t) { count(); }
void __sanitizer_cov_trace_const_cmp4(std::uint32_t, std::uint32_t) { count(); }
void __sanitizer_cov_trace_const_cmp8(std::uint64_t, std::uint64_t) { count(); }
void __sanitizer_cov_trace_switch(std::uint64_t, std::uint64_t*) { count(); }
}
