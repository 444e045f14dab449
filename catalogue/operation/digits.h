// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// Small domains of exhaustive runs whose configurations are numbers with a fixed count of digits.
namespace touchstone::catalogue {

/// size^digits: the number of configurations.
inline std::uint64_t configurations_of_digits(int size, int digits) {
  std::uint64_t count = 1;
  for (int i = 0; i < digits; ++i) count *= static_cast<std::uint64_t>(size);
  return count;
}

/// The digits of a configuration's index, the fastest first.
class Digits {
 public:
  Digits(int size, std::uint64_t index) : size_(static_cast<std::uint64_t>(size)), left_(index) {}
  double operator()() { return static_cast<double>(next(size_)); }
  /// One of another size than the others.
  std::uint64_t next(std::uint64_t size) {
    const std::uint64_t digit = left_ % size;
    left_ /= size;
    return digit;
  }

 private:
  std::uint64_t size_, left_;
};

}  // namespace touchstone::catalogue
