// SPDX-License-Identifier: Apache-2.0
#include "arithmetic/integer.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <vector>

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {

Memory& memory() {
  static Memory where{[](std::size_t bytes) { return ::operator new(bytes); },
                      [](void* piece, std::size_t) { ::operator delete(piece); }};
  return where;
}

void Integer::reserve(std::size_t count) {
  if (count <= capacity_) return;
  const auto more = static_cast<std::uint32_t>(count + count / 4 + 1);
  auto* const fresh = static_cast<Word*>(memory().take(more * sizeof(Word)));
  std::memcpy(fresh, words(), size_ * sizeof(Word));
  release();
  memory_ = fresh, capacity_ = more;
}

void Integer::assign(const Integer& b) {
  size_ = std::min(size_, b.size_);  // what is overwritten need not be kept
  reserve(b.size_);
  std::memcpy(data(), b.words(), b.size_ * sizeof(Word));
  size_ = b.size_, negative_ = b.negative_;
}

std::uint64_t Integer::zeros() const {
  if (size_ == 0) return ~std::uint64_t{0};
  std::size_t i = 0;
  while (words()[i] == 0) ++i;
  return word_bits * i + static_cast<std::size_t>(std::countr_zero(words()[i]));
}

std::uint64_t Integer::bits64_from(std::size_t place) const {
  const std::size_t i = place / word_bits, part = place % word_bits;
  const auto from = [this](std::size_t first) {
    if constexpr (word_bits == 64) return word(first);
    else return word(first) | static_cast<std::uint64_t>(word(first + 1)) << 32;
  };
  const std::uint64_t below = from(i);
  return part == 0 ? below : below >> part | from(i + 64 / word_bits) << (64 - part);
}

void Integer::set_bits64(const std::uint64_t* bits, std::size_t count) {
  constexpr std::size_t parts = 64 / word_bits;
  size_ = 0;
  reserve(parts * count);
  for (std::size_t i = 0; i < parts * count; ++i)
    data()[i] = static_cast<Word>(bits[i / parts] >> (i % parts * word_bits));
  size_ = static_cast<std::uint32_t>(parts * count), negative_ = false;
  trim();
}

void Integer::set_bit(std::size_t place, bool one) {
  const std::size_t i = place / word_bits;
  const Word bit = Word{1} << place % word_bits;
  if (i >= size_) {
    if (!one) return;
    reserve(i + 1);
    std::fill(data() + size_, data() + i + 1, Word{0});
    size_ = static_cast<std::uint32_t>(i + 1);
  }
  data()[i] = one ? data()[i] | bit : data()[i] & ~bit;
  trim();
}

std::uint64_t Integer::count_ones() const {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < size_; ++i) count += static_cast<std::uint64_t>(std::popcount(words()[i]));
  return count;
}

Integer& Integer::accumulate(const Integer& b, bool minus) {
  if (b.size_ == 0) return *this;
  if (size_ == 0) {
    assign(b);
    negative_ = minus;
    return *this;
  }
  const std::size_t n = size_, m = b.size_, longest = std::max(n, m);
  reserve(longest + 1);  // which may move b, if it is this number
  Word* const w = data();
  const Word* const x = b.words();
  if (negative_ == minus) {
    const Word carry = n >= m ? add(w, w, n, x, m) : add(w, x, m, w, n);
    w[longest] = carry;
    size_ = static_cast<std::uint32_t>(longest + carry);
    return *this;
  }
  if (arithmetic::compare(w, n, x, m) >= 0) subtract(w, w, n, x, m);
  else subtract(w, x, m, w, n), negative_ = minus;
  size_ = static_cast<std::uint32_t>(longest);
  trim();
  return *this;
}

Integer Integer::product(const Integer& a, const Integer& b) {
  Integer result;
  if (a.size_ == 0 || b.size_ == 0) return result;
  const std::size_t size = std::size_t{a.size_} + b.size_;
  result.reserve(size);
  if (a.size_ >= b.size_) multiply(result.data(), a.words(), a.size_, b.words(), b.size_);
  else multiply(result.data(), b.words(), b.size_, a.words(), a.size_);
  result.size_ = static_cast<std::uint32_t>(size - (result.data()[size - 1] == 0));
  result.negative_ = a.negative_ != b.negative_;
  return result;
}

Integer& Integer::operator<<=(std::uint64_t bits) {
  if (size_ == 0 || bits == 0) return *this;
  const std::size_t up = bits / word_bits, before = size_;
  reserve(before + up + 1);
  Word* const w = data();
  const Word above = shift_up(w + up, w, before, bits % word_bits);
  std::fill(w, w + up, Word{0});
  w[before + up] = above;
  size_ = static_cast<std::uint32_t>(before + up + (above != 0));
  return *this;
}

void Integer::cut(std::uint64_t bits) {
  const std::uint64_t down = bits / word_bits;
  if (down >= size_) {
    size_ = 0, negative_ = false;
    return;
  }
  Word* const w = data();
  size_ -= static_cast<std::uint32_t>(down);
  shift_down(w, w + down, size_, bits % word_bits);
  trim();
}

Integer& Integer::operator>>=(std::uint64_t bits) {
  const bool further = negative_ && zeros() < bits;
  cut(bits);
  if (further) --*this;
  return *this;
}

void Integer::set_double(double x) {  // by its bits: of doubles even a comparison depends on the environment
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto field = static_cast<int>(bits >> 52 & 0x7ff);
  set_magnitude(field < 1023 ? 0 : (bits & 0xfffffffffffffu) | 0x10000000000000u);
  if (field >= 1075) *this <<= static_cast<std::uint64_t>(field - 1075);
  else cut(static_cast<std::uint64_t>(1075 - field));
  set_negative(bits >> 63 != 0);
}

double Integer::leading_digits(std::int64_t& exponent) const {
  const std::size_t bits = bit_length(), most = std::min<std::size_t>(bits, 53);
  exponent = static_cast<std::int64_t>(bits);
  const double digits = static_cast<double>(bits64_from(bits - most) & ((std::uint64_t{1} << most) - 1));
  return std::ldexp(negative_ ? -digits : digits, -static_cast<int>(most));
}

double Integer::get_d() const {
  std::int64_t exponent = 0;
  const double digits = leading_digits(exponent);
  return std::ldexp(digits, static_cast<int>(std::min<std::int64_t>(exponent, 5000)));
}

namespace {

/// The greatest power of a base that a word holds.
struct Block {
  Word scale;
  int digits;
};
Block block_of(int base) {
  Block found{1, 0};
  while (high(static_cast<TwoWords>(found.scale) * static_cast<Word>(base)) == 0)
    found.scale *= static_cast<Word>(base), ++found.digits;
  return found;
}

int value_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'z') return c - 'a' + 10;
  return c >= 'A' && c <= 'Z' ? c - 'A' + 10 : 99;
}

}  // namespace

std::string Integer::get_str(int base) const {
  if (size_ == 0) return "0";
  const Block block = block_of(base);
  std::vector<Word> left(words(), words() + size_);
  std::string text;
  while (!left.empty()) {
    Word rest = 0;
    for (std::size_t i = left.size(); i-- > 0;) {
      const TwoWords t = pair(rest, left[i]);
      left[i] = low(t / block.scale), rest = low(t % block.scale);
    }
    while (!left.empty() && left.back() == 0) left.pop_back();
    for (int k = 0; k < block.digits && (rest != 0 || !left.empty()); ++k) {
      text += "0123456789abcdefghijklmnopqrstuvwxyz"[rest % static_cast<Word>(base)];
      rest /= static_cast<Word>(base);
    }
  }
  if (negative_) text += '-';
  std::reverse(text.begin(), text.end());
  return text;
}

int Integer::set_str(const std::string& text, int base) {
  const std::size_t first = !text.empty() && text[0] == '-' ? 1 : 0;
  if (first == text.size()) return -1;
  const Block block = block_of(base);
  Integer value;
  for (std::size_t i = first; i < text.size();) {
    Word part = 0, scale = 1;
    for (int k = 0; k < block.digits && i < text.size(); ++k, ++i) {
      const int digit = value_of(text[i]);
      if (digit >= base) return -1;
      part = part * static_cast<Word>(base) + static_cast<Word>(digit), scale *= static_cast<Word>(base);
    }
    value = value * Integer(scale) + Integer(part);
  }
  value.set_negative(first == 1);
  *this = std::move(value);
  return 0;
}

Integer power(Integer base, std::uint64_t exponent) {
  Integer result(1);
  for (; exponent != 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result *= base;
    if (exponent > 1) base *= base;
  }
  return result;
}

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
