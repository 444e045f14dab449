// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <cstring>

#include "audit/inputs/choices.h"
#include "audit/inputs/numbers.h"
#include "fuzz/driver/target.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace touchstone::fuzz {
namespace {

using audit::Choices;
using Numbers = std::vector<double>;

class Mutation {
 public:
  Mutation(Numbers& numbers, Choices& choices) : numbers_(numbers), choices_(choices), points_(target().points()) {}

  void apply() {
    switch (choices_.below(12)) {
      case 0: case 1: case 2: return nudge();
      case 3: case 4: return snap_to_line();
      case 5: return coincide();
      case 6: return copy_number();
      case 7: return small_integer();
      case 8: return common_power();
      case 9: return swap_points();
      case 10: return flip_bits();
      default: return typed();
    }
  }

 private:
  double& any_number() { return numbers_[choices_.below(numbers_.size())]; }
  std::pair<std::size_t, std::size_t> any_point() { return points_[choices_.below(points_.size())]; }

  void nudge() {
    double& number = any_number();
    const int ulps = 1 + static_cast<int>(choices_.below(3));
    if (std::isfinite(number)) number = audit::moved_by_ulps(number, choices_.below(2) == 1 ? -ulps : ulps);
  }

  /// r = p + k/8 (q - p), rounded: mostly next to the line, sometimes on it.
  void snap_to_line() {
    if (points_.size() < 2) return nudge();
    const auto p = any_point(), q = any_point(), r = any_point();
    const double t = (static_cast<double>(choices_.below(25)) - 8) / 8;
    numbers_[r.first] = numbers_[p.first] + t * (numbers_[q.first] - numbers_[p.first]);
    numbers_[r.second] = numbers_[p.second] + t * (numbers_[q.second] - numbers_[p.second]);
  }

  void coincide() {
    if (points_.size() < 2) return copy_number();
    const auto p = any_point(), q = any_point();
    numbers_[q.first] = numbers_[p.first];
    numbers_[q.second] = numbers_[p.second];
  }

  void copy_number() {
    const double copied = any_number();
    any_number() = choices_.below(4) == 3 ? -copied : copied;
  }

  void small_integer() { any_number() = audit::small_integer(choices_); }
  void typed() { any_number() = audit::typed(choices_); }

  void common_power() {
    const int power = choices_.below(2) == 1 ? static_cast<int>(choices_.below(2098)) - 1074 : static_cast<int>(choices_.below(21)) - 10;
    for (double& number : numbers_) {
      const double multiplied = std::ldexp(number, power);
      if (std::isfinite(multiplied)) number = multiplied;
    }
  }

  void swap_points() {
    if (points_.size() < 2) return std::swap(any_number(), any_number());
    const auto p = any_point(), q = any_point();
    std::swap(numbers_[p.first], numbers_[q.first]);
    std::swap(numbers_[p.second], numbers_[q.second]);
  }

  void flip_bits() {
    double& number = any_number();
    number = std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) ^ std::uint64_t{1} << choices_.below(64));
  }

  Numbers& numbers_;
  Choices& choices_;
  const std::vector<std::pair<std::size_t, std::size_t>>& points_;
};

}  // namespace

void encode(const std::vector<double>& numbers, std::vector<std::uint8_t>& data) {
  data.resize(1 + numbers.size() * sizeof(double));
  data[0] = numbers_follow;
  std::memcpy(data.data() + 1, numbers.data(), numbers.size() * sizeof(double));
}

bool mutated(Bytes data, unsigned seed, std::vector<std::uint8_t>& result) {
  Choices choices = Choices::seeded(seed);
  if (choices.below(8) == 0) return false;
  static thread_local Numbers numbers;
  target().decode(data, numbers);
  for (std::uint64_t left = 1 + choices.below(3); left > 0; --left) Mutation(numbers, choices).apply();
  encode(numbers, result);
  return true;
}

}  // namespace touchstone::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
  static thread_local std::vector<std::uint8_t> result;
  if (!touchstone::fuzz::mutated({data, size}, seed, result) || result.size() > max_size) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  std::memcpy(data, result.data(), result.size());
  return result.size();
}
