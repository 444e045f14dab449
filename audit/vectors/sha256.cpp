// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/sha256.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace touchstone::audit {
namespace {

/// The first 32 bits of the fractional parts of the nth roots of the first primes, as the standard defines its
/// constants.
template <std::size_t count>
std::array<std::uint32_t, count> bits_of_roots(unsigned n) {
  std::array<std::uint32_t, count> bits{};
  std::vector<unsigned> primes;
  for (unsigned i = 2; primes.size() < count; ++i) {
    if (std::any_of(primes.begin(), primes.end(), [i](unsigned prime) { return i % prime == 0; })) continue;
    mpz_class root = mpz_class(i) << (32 * n);
    mpz_root(root.get_mpz_t(), root.get_mpz_t(), n);
    bits[primes.size()] = static_cast<std::uint32_t>(mpz_class(root & 0xffffffffu).get_ui());
    primes.push_back(i);
  }
  return bits;
}

std::uint32_t turned(std::uint32_t x, int a, int b, int c) {
  return std::rotr(x, a) ^ std::rotr(x, b) ^ std::rotr(x, c);
}
std::uint32_t shifted(std::uint32_t x, int a, int b, int c) { return std::rotr(x, a) ^ std::rotr(x, b) ^ (x >> c); }

void add_block(const unsigned char* bytes, std::array<std::uint32_t, 8>& hash) {
  static const auto constants = bits_of_roots<64>(3);
  std::array<std::uint32_t, 64> w{};
  for (std::size_t i = 0; i < 16; ++i)
    for (std::size_t j = 0; j < 4; ++j) w[i] = w[i] << 8 | bytes[4 * i + j];
  for (std::size_t i = 16; i < 64; ++i)
    w[i] = shifted(w[i - 2], 17, 19, 10) + w[i - 7] + shifted(w[i - 15], 7, 18, 3) + w[i - 16];
  auto [a, b, c, d, e, f, g, h] = hash;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t first = h + turned(e, 6, 11, 25) + ((e & f) ^ (~e & g)) + constants[i] + w[i];
    const std::uint32_t second = turned(a, 2, 13, 22) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
  }
  const std::array<std::uint32_t, 8> sums{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < 8; ++i) hash[i] += sums[i];
}

}  // namespace

std::string sha256(const std::string& text) {
  std::string padded = text + '\x80';
  while (padded.size() % 64 != 56) padded += '\0';
  const std::uint64_t bits = text.size() * 8;
  for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(bits >> shift & 0xff);
  std::array<std::uint32_t, 8> hash = bits_of_roots<8>(2);
  for (std::size_t at = 0; at < padded.size(); at += 64)
    add_block(reinterpret_cast<const unsigned char*>(padded.data()) + at, hash);
  std::string digits;
  for (const std::uint32_t word : hash) {
    std::array<char, 9> printed{};
    std::snprintf(printed.data(), printed.size(), "%08x", word);
    digits += printed.data();
  }
  return digits;
}

}  // namespace touchstone::audit
