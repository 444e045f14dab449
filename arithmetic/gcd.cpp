// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "arithmetic/integer.h"

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {
namespace {

/// The greatest common divisor of two numbers below 2^64, not both 0. J. Stein, Computational problems associated with
/// Racah algebra (1967).
std::uint64_t gcd_of_bits(std::uint64_t x, std::uint64_t y) {
  if (x == 0 || y == 0) return x | y;
  const int twos = std::countr_zero(x | y);
  x >>= std::countr_zero(x);
  while (y != 0) {
    y >>= std::countr_zero(y);
    if (x > y) std::swap(x, y);
    y -= x;
  }
  return x << twos;
}

/// Euclid's steps that the leading digits of x >= y decide, as one matrix: x becomes a x + b y, y becomes c x + d y.
/// D. H. Lehmer, Euclid's algorithm for large numbers (1938); Knuth, The Art of Computer Programming 2, 4.5.2,
/// algorithm L: a quotient is right for the numbers if it is the same at both ends of what their leading digits allow.
struct Steps {
  std::int64_t a = 1, b = 0, c = 0, d = 1;

  Steps(std::int64_t x, std::int64_t y) {  // below 2^62
    constexpr std::int64_t most = std::int64_t{1} << 30;
    while (y + c != 0 && y + d != 0) {
      const std::int64_t q = (x + a) / (y + c);
      if (q != (x + b) / (y + d) || q >= most) return;
      const std::int64_t next_c = a - q * c, next_d = b - q * d;
      if (next_c >= most || next_c <= -most || next_d >= most || next_d <= -most) return;
      a = c, c = next_c, b = d, d = next_d;
      std::swap(x, y);
      y -= q * x;
    }
  }
};

}  // namespace

/// *this >= b, both long: some of Euclid's steps.
void Integer::lehmer_step(Integer& b) {
  const std::size_t below = bit_length() - 62;
  const Steps steps(static_cast<std::int64_t>(bits64_from(below)), static_cast<std::int64_t>(b.bits64_from(below)));
  if (steps.b == 0) {  // they decide none
    *this %= b;
    std::swap(*this, b);
    return;
  }
  b.reserve(size_);
  std::fill(b.data() + b.size_, b.data() + size_, Word{0});
  Word *const x = data(), *const y = b.data();
  SignedTwoWords first = 0, second = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const SignedTwoWords p = x[i], q = y[i];
    first += steps.a * p + steps.b * q, second += steps.c * p + steps.d * q;
    x[i] = static_cast<Word>(first), y[i] = static_cast<Word>(second);
    first >>= word_bits, second >>= word_bits;
  }
  b.size_ = size_;
  trim(), b.trim();
}

Integer gcd(const Integer& a, const Integer& b) {
  if (a.is_zero() || b.is_zero()) return abs(a.is_zero() ? b : a);
  const std::uint64_t twos_of_a = a.zeros(), twos_of_b = b.zeros();
  if (twos_of_a + 1 == a.bit_length() || twos_of_b + 1 == b.bit_length())  // as most denominators, a power of two
    return Integer(1) << std::min(twos_of_a, twos_of_b);
  Integer x = abs(a), y = abs(b);
  if (Integer::compare_magnitudes(x, y) < 0) std::swap(x, y);
  while (y.bit_length() > 64) x.lehmer_step(y);
  if (y.is_zero()) return x;
  if (x.bit_length() > 64) {
    x %= y;
    std::swap(x, y);
  }
  return Integer(gcd_of_bits(x.bits64(), y.bits64()));
}

Integer lcm(const Integer& a, const Integer& b) {
  if (a.is_zero() || b.is_zero()) return {};
  return abs(a == b ? a : a / gcd(a, b) * b);
}

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
