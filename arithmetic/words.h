// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

/// Digits of integers: words of 64 bits where the machine has them, else of 32, in the order of their places, the
/// lowest first. Numbers here are long enough for words to matter, and too short for more than the schoolbook's
/// product: few have more than a hundred words.
///
/// TOUCHSTONE_SMALL_WORDS chooses 32 bits anywhere. The name of the inline namespace tells the two apart, so that one
/// program may hold both.
#if defined(__SIZEOF_INT128__) && UINTPTR_MAX > 0xffffffffu && !defined(TOUCHSTONE_SMALL_WORDS)
#define TOUCHSTONE_WORDS words_of_64_bits
#else
#define TOUCHSTONE_WORDS words_of_32_bits
#endif

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {

#if defined(__SIZEOF_INT128__) && UINTPTR_MAX > 0xffffffffu && !defined(TOUCHSTONE_SMALL_WORDS)
using Word = std::uint64_t;
__extension__ using TwoWords = unsigned __int128;
__extension__ using SignedTwoWords = __int128;
#else
using Word = std::uint32_t;
using TwoWords = std::uint64_t;
using SignedTwoWords = std::int64_t;
#endif
inline constexpr std::size_t word_bits = 8 * sizeof(Word);

inline Word low(TwoWords x) { return static_cast<Word>(x); }
inline Word high(TwoWords x) { return static_cast<Word>(x >> word_bits); }
inline TwoWords pair(Word above, Word below) { return static_cast<TwoWords>(above) << word_bits | below; }

/// -1, 0, 1, neither with zeros above its highest digit.
inline int compare(const Word* a, std::size_t n, const Word* b, std::size_t m) {
  if (n != m) return n < m ? -1 : 1;
  while (n-- > 0)
    if (a[n] != b[n]) return a[n] < b[n] ? -1 : 1;
  return 0;
}

/// sum = a + b, n >= m; returns the carry. sum may be a or b.
inline Word add(Word* sum, const Word* a, std::size_t n, const Word* b, std::size_t m) {
  Word carry = 0;
  std::size_t i = 0;
  for (; i < m; ++i) {
    const TwoWords t = static_cast<TwoWords>(a[i]) + b[i] + carry;
    sum[i] = low(t), carry = high(t);
  }
  for (; i < n; ++i) {
    const TwoWords t = static_cast<TwoWords>(a[i]) + carry;
    sum[i] = low(t), carry = high(t);
  }
  return carry;
}

/// difference = a - b, n >= m; returns the borrow, which is 0 if a >= b. difference may be a or b.
inline Word subtract(Word* difference, const Word* a, std::size_t n, const Word* b, std::size_t m) {
  Word borrow = 0;
  std::size_t i = 0;
  for (; i < m; ++i) {
    const TwoWords t = static_cast<TwoWords>(a[i]) - b[i] - borrow;
    difference[i] = low(t), borrow = high(t) & 1;
  }
  for (; i < n; ++i) {
    const TwoWords t = static_cast<TwoWords>(a[i]) - borrow;
    difference[i] = low(t), borrow = high(t) & 1;
  }
  return borrow;
}

/// r += a by, of n words; returns the carry.
inline Word add_product(Word* r, const Word* a, std::size_t n, Word by) {
  Word carry = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const TwoWords t = static_cast<TwoWords>(a[i]) * by + r[i] + carry;  // at most 2^(2 word_bits) - 1
    r[i] = low(t), carry = high(t);
  }
  return carry;
}

/// r -= a by, of n words; returns the borrow.
inline Word subtract_product(Word* r, const Word* a, std::size_t n, Word by) {
  Word borrow = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const TwoWords t = static_cast<TwoWords>(a[i]) * by + borrow;
    borrow = high(t) + (r[i] < low(t)), r[i] -= low(t);
  }
  return borrow;
}

/// product = a b, of n + m words; it is neither a nor b. Knuth, The Art of Computer Programming 2, 4.3.1, algorithm M.
inline void multiply(Word* product, const Word* a, std::size_t n, const Word* b, std::size_t m) {
  for (std::size_t i = 0; i < n; ++i) product[i] = 0;
  for (std::size_t j = 0; j < m; ++j) product[n + j] = add_product(product + j, a, n, b[j]);
}

/// r = a 2^bits, 0 <= bits < word_bits; returns what leaves at the top. r may be a, or lie above it.
inline Word shift_up(Word* r, const Word* a, std::size_t n, std::size_t bits) {
  Word above = 0;
  for (std::size_t i = n; i-- > 0;) {
    const TwoWords t = static_cast<TwoWords>(a[i]) << bits;
    if (i + 1 == n) above = high(t);
    else r[i + 1] |= high(t);
    r[i] = low(t);
  }
  return above;
}

/// r = a / 2^bits without a rest, 0 <= bits < word_bits. r may be a, or lie below it.
inline void shift_down(Word* r, const Word* a, std::size_t n, std::size_t bits) {
  for (std::size_t i = 0; i < n; ++i) r[i] = low(pair(i + 1 < n ? a[i + 1] : 0, a[i]) >> bits);
}

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
