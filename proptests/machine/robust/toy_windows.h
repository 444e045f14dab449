// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include "proptests/catch.h"
#include "proptests/machine/robust/toy_float.h"

/// Sets of inputs of a toy format, and the count of what a filter says on all of them.
namespace touchstone::proptests {

inline int sign_of(double x) { return (x > 0) - (x < 0); }

struct Count {
  std::uint64_t cases = 0, certain = 0, wrong = 0;
  void add(robust::filters::Sign said, int truth) {
    using robust::filters::Sign;
    ++cases;
    if (said == Sign::unknown) return;
    ++certain;
    wrong += (said == Sign::positive ? 1 : -1) != truth;
  }
  friend Count operator+(const Count& a, const Count& b) {
    return {a.cases + b.cases, a.certain + b.certain, a.wrong + b.wrong};
  }
};

/// All numbers k 2^exponent of the format with |k| <= most.
template <class Float>
std::vector<double> window(int most, int exponent) {
  std::vector<double> numbers;
  for (int k = -most; k <= most; ++k) {
    const double number = std::ldexp(k, exponent);
    if (Float::rounded(number, {}) == number) numbers.push_back(number);
  }
  return numbers;
}

/// The lower half of a binade, of both signs: m 2^exponent where m has as many bits as the format. Differences of
/// opposite signs are rounded, and relatively most of all.
template <class Float, class Format>
std::vector<double> half_binade(int exponent) {
  std::vector<double> numbers;
  for (int m = 1 << (Format::precision - 1); m <= 3 << (Format::precision - 2); ++m) {
    numbers.push_back(std::ldexp(m, exponent)), numbers.push_back(-numbers.back());
  }
  return numbers;
}

/// A difference of two inputs: exactly, and as the format has it in the present environment.
template <class Float>
struct Difference {
  double exact;
  Float computed;
};

template <class Float>
std::vector<Difference<Float>> differences(const std::vector<double>& inputs) {
  std::vector<Difference<Float>> made;
  std::set<double> seen;
  for (const double a : inputs) {
    for (const double b : inputs) {
      if (seen.insert(a - b).second) made.push_back({a - b, Float::of(a) - Float::of(b)});
    }
  }
  return made;
}

/// Runs `ask` in four rounding modes, each with gradual underflow, with FTZ, and with FTZ and DAZ.
template <class Float, class Ask>
Count in_all_environments(const Ask& ask) {
  Count sum;
  for (int rounding = 0; rounding < 4; ++rounding) {
    for (const auto& [flush, zeros] : {std::pair{false, false}, {true, false}, {true, true}}) {
      Float::set({rounding, flush, zeros});
      sum = sum + ask();
    }
  }
  return sum;
}

/// The constants of a format as long as in scope: multiplied, to see that too small ones are found out.
template <class Format>
struct Weakened {
  Weakened(double relative, double absolute) { Format::relative = relative, Format::absolute = absolute; }
  ~Weakened() { Format::relative = Format::absolute = 1; }
};

/// What is wrong in all environments with the constants of the format multiplied, where some is certain.
template <class Float, class Format, class Ask>
std::uint64_t wrong_with(double relative, double absolute, const Ask& ask) {
  const Weakened<Format> constants(relative, absolute);
  const Count count = in_all_environments<Float>(ask);
  CHECK(count.certain > 0);
  return count.wrong;
}

}  // namespace touchstone::proptests
