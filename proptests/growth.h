// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <ctime>

namespace touchstone::proptests {

/// How many times as much processor time work(8 n) takes as work(n): about 8 where the time is n, 10 where it is n log
/// n, 64 where it is n^2. The middle of the last two, as factors go, tells them apart.
constexpr double far_below_quadratic = 25;

/// Of three measurements of each the least, taken in turn, and of ten where that still looks like n^2: what else the
/// processor does only adds, but may do so for a while.
template <class Work>
double growth(const Work& work, std::size_t n) {
  const auto time_of = [&work](std::size_t size) {
    const std::clock_t start = std::clock();
    std::clock_t spent = 0;
    int times = 0;
    // Long enough for the clock to tell.
    for (; spent < CLOCKS_PER_SEC / 50; spent = std::clock() - start) work(size), ++times;
    return static_cast<double>(spent) / times;
  };
  double small = time_of(n), large = time_of(8 * n);
  for (int again = 0; again < 2 || (again < 9 && large >= far_below_quadratic * small); ++again)
    small = std::min(small, time_of(n)), large = std::min(large, time_of(8 * n));
  return large / small;
}

}  // namespace touchstone::proptests
