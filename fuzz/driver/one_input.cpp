// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "catalogue/numbers/ulps.h"
#include "fuzz/driver/target.h"

namespace touchstone::fuzz {
namespace {

constexpr std::size_t degrees_of_nearness = 128, outcomes = 16;  // larger ones share the last place
#if defined(__linux__)
[[gnu::section("__libfuzzer_extra_counters")]]
#endif
std::array<std::uint8_t, degrees_of_nearness * outcomes>
    nearness;

/// floor(log2 |x|) or one more; x is not zero.
std::int64_t magnitude(const mpq_class& x) {
  return static_cast<std::int64_t>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) -
         static_cast<std::int64_t>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
}

int exponent(double x) { return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff) - 1023; }

}  // namespace

void report_margin(const mpq_class& margin, int degree, std::span<const double> numbers, std::size_t outcome) {
  std::size_t near = 0;  // exactly degenerate
  if (sgn(margin) != 0) {
    int greatest = -1023;
    for (const double number : numbers) greatest = std::max(greatest, exponent(number));
    const std::int64_t bits =
        static_cast<std::int64_t>(degree) * greatest - magnitude(margin);  // about 53 if rounding decides
    near = static_cast<std::size_t>(std::clamp<std::int64_t>(bits, 0, std::int64_t{degrees_of_nearness} - 2)) + 1;
  }
  nearness[std::min(outcome, outcomes - 1) * degrees_of_nearness + near] = 1;
}

}  // namespace touchstone::fuzz

/// Keeps no allocation stacks and a small quarantine: under the address sanitizer, half of the time goes into recording
/// allocations.
extern "C" const char* __asan_default_options() { return "malloc_context_size=0:quarantine_size_mb=4"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace touchstone::fuzz;
  const std::string wrong = target().complaint({data, size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n%s\n", wrong.c_str(), target().shown({data, size}).c_str());
  std::abort();
}
