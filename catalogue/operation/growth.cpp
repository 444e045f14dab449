// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/growth.h"

#include <array>
#include <bit>
#include <limits>

namespace touchstone::catalogue {
namespace {

/// n^power (log n)^logarithms
struct Terms {
  const char* name;
  int power, logarithms;
};
constexpr std::array<Terms, 7> all_terms{
    {{"1", 0, 0}, {"n", 1, 0}, {"n log n", 1, 1}, {"n^2", 2, 0}, {"n^2 log n", 2, 1}, {"n^3", 3, 0}, {"n^4", 4, 0}}};

const Terms& terms_of(Growth growth) { return all_terms[static_cast<std::size_t>(growth)]; }

}  // namespace

std::string name_of(Growth growth) { return terms_of(growth).name; }

std::uint64_t steps_of(Growth growth, std::uint64_t n) {
  std::uint64_t steps = 1;
  const auto times = [&steps](std::uint64_t factor) {
    if (__builtin_mul_overflow(steps, factor, &steps)) steps = std::numeric_limits<std::uint64_t>::max();
  };
  for (int k = 0; k < terms_of(growth).power; ++k) times(n);
  for (int k = 0; k < terms_of(growth).logarithms; ++k) times(static_cast<std::uint64_t>(std::bit_width(n)));
  return steps;
}

}  // namespace touchstone::catalogue
