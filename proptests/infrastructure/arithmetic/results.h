// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The results of an arithmetic for a drawn case. results.cpp is compiled once for each: with GMP and MPFR, and with
/// ours in words of 64 and of 32 bits.
namespace touchstone::proptests::arithmetic_results {

struct Result {
  std::string what, value;
};
using Results = std::vector<Result>;

namespace with_gmp {
Results integers(std::uint64_t seed);
Results rationals(std::uint64_t seed);
Results rounded(std::uint64_t seed);
}  // namespace with_gmp
namespace with_own {
Results integers(std::uint64_t seed);
Results rationals(std::uint64_t seed);
Results rounded(std::uint64_t seed);
}  // namespace with_own
namespace with_small_words {
Results integers(std::uint64_t seed);
Results rationals(std::uint64_t seed);
Results rounded(std::uint64_t seed);
}  // namespace with_small_words

}  // namespace touchstone::proptests::arithmetic_results
