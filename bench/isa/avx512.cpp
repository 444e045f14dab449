// SPDX-License-Identifier: Apache-2.0
#define TOUCHSTONE_LANES 8
#include "bench/isa/naive.h"

namespace touchstone::robust::batch::isa {

const NaiveLoops avx512_loops = loops_of_this_unit;

double sum_of(const double* numbers, std::size_t count) {
  Lanes sums[chunk / lanes];
  for (Lanes& sum : sums) sum = same(0);
  for (std::size_t first = 0; first < count; first += chunk)
    for (std::size_t k = 0; k < chunk / lanes; ++k) sums[k] = sums[k] + Lanes::at(numbers + first + k * lanes);
  double total = 0;
  for (const Lanes& sum : sums)
    for (std::size_t k = 0; k < lanes; ++k) total += sum.v[k];
  return total;
}

}  // namespace touchstone::robust::batch::isa
