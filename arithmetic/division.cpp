// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "arithmetic/integer.h"

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {
namespace {

/// Divides two words by one whose highest bit is set, with two products instead of a division of the machine. N.
/// Moeller and T. Granlund, Improved division by invariant integers, IEEE Transactions on Computers 60 (2011),
/// algorithm 4.
class Divisor {
 public:
  explicit Divisor(Word d) : d_(d), reciprocal_(low(~TwoWords{0} / d)) {}  // floor((B^2 - 1) / d) - B, B = 2^word_bits
  /// above < d
  Word operator()(Word above, Word below, Word& rest) const {
    const TwoWords q = static_cast<TwoWords>(reciprocal_) * above + pair(above, below);
    Word quotient = static_cast<Word>(high(q) + 1);
    rest = static_cast<Word>(below - quotient * d_);
    if (rest > low(q)) --quotient, rest += d_;
    if (rest >= d_) ++quotient, rest -= d_;
    return quotient;
  }

 private:
  Word d_, reciprocal_;
};

/// x, of n + m words and one more above them, by y of n >= 2 words, the highest bit of which is set: leaves the rest in
/// x, and in q, if it is not nullptr, the quotient of m + 1 words. Knuth, The Art of Computer Programming 2, 4.3.1,
/// algorithm D.
void divide_words(Word* x, std::size_t m, const Word* y, std::size_t n, Word* q) {
  const Word top = y[n - 1], next = y[n - 2];
  const Divisor by_top(top);
  for (std::size_t j = m + 1; j-- > 0;) {
    Word* const part = x + j;  // below y B
    Word guess = ~Word{0};
    if (part[n] < top) {
      Word rest = 0;
      guess = by_top(part[n], part[n - 1], rest);
      // The guess is too great by at most 2; a word more of both tells, but for a case in about B / 2.
      while (static_cast<TwoWords>(guess) * next > pair(rest, part[n - 2])) {
        --guess;
        rest += top;
        if (rest < top) break;
      }
    }
    part[n] -= subtract_product(part, y, n, guess);
    while (part[n] != 0) {  // below 0: the guess was too great, if it was the greatest word by 2 at most
      --guess;
      part[n] += add(part, part, n, y, n);
    }
    if (q != nullptr) q[j] = guess;
  }
}

}  // namespace

void Integer::divide(const Integer& a, const Integer& b, Integer* quotient, Integer* rest) {
  const bool quotient_negative = a.negative_ != b.negative_, rest_negative = a.negative_;
  if (compare_magnitudes(a, b) < 0) {
    if (rest != nullptr && rest != &a) *rest = a;
    if (quotient != nullptr) *quotient = Integer();
    return;
  }
  if (a.size_ <= 64 / word_bits) {
    const std::uint64_t x = a.bits64(), y = b.bits64();
    if (quotient != nullptr) quotient->set_magnitude(x / y), quotient->set_negative(quotient_negative);
    if (rest != nullptr) rest->set_magnitude(x % y), rest->set_negative(rest_negative);
    return;
  }
  const std::size_t n = b.size_, m = a.size_ - n;
  const auto shift = static_cast<std::size_t>(std::countl_zero(b.words()[n - 1]));
  Integer x, q;
  x.reserve(n + m + 1);
  x.data()[n + m] = shift_up(x.data(), a.words(), n + m, shift);
  x.size_ = static_cast<std::uint32_t>(n + m + 1);
  if (quotient != nullptr) q.reserve(m + 1);
  Word* const digits = quotient != nullptr ? q.data() : nullptr;
  if (n == 1) {
    const Divisor by(static_cast<Word>(b.words()[0] << shift));
    Word left = x.data()[m + 1];
    for (std::size_t i = m + 1; i-- > 0;) {
      const Word digit = by(left, x.data()[i], left);
      if (digits != nullptr) digits[i] = digit;
    }
    x.data()[0] = left, x.size_ = 1;
  } else {
    const Integer y = shift == 0 ? Integer() : b << shift;
    divide_words(x.data(), m, shift == 0 ? b.words() : y.words(), n, digits);
    x.size_ = static_cast<std::uint32_t>(n);
  }
  if (rest != nullptr) {
    x.trim();
    x.cut(shift);
    x.set_negative(rest_negative);
    *rest = std::move(x);
  }
  if (quotient != nullptr) {
    q.size_ = static_cast<std::uint32_t>(m + 1);
    q.trim();
    q.set_negative(quotient_negative);
    *quotient = std::move(q);
  }
}

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
