// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>

#include "robust/batch/isa/lanes/lanes.h"

/// Answers as bytes, for instruction sets that have no masks of bytes.
namespace touchstone::robust::batch::isa {
namespace {

void put_bytes(std::uint8_t* to, std::uint64_t bits, std::uint8_t set, std::uint8_t clear) {
  constexpr std::uint64_t ones = 0x0101010101010101, own_bit = 0x8040201008040201;
  for (std::size_t k = 0; k < 64; k += 8) {
    // In byte j of eight copies of eight bits only bit j is kept; adding 0x7f makes a carry into its highest bit.
    const std::uint64_t kept = (bits >> k & 0xff) * ones & own_bit;
    const std::uint64_t chosen = (kept + 0x7f * ones) >> 7 & ones;
    std::uint64_t bytes = clear * ones ^ chosen * static_cast<std::uint8_t>(set ^ clear);
    if constexpr (std::endian::native == std::endian::big) bytes = __builtin_bswap64(bytes);
    std::memcpy(to + k, &bytes, sizeof bytes);
  }
}

[[maybe_unused]] void put_answers(std::uint8_t* to, std::uint64_t where, std::uint64_t one, std::uint64_t two) {
  constexpr std::size_t rows = 64;
  std::uint8_t ones[rows], twos[rows];
  put_bytes(ones, one, 1, 0);
  put_bytes(twos, two, 2, 0);
  for (std::size_t i = 0; i < rows; ++i) ones[i] |= twos[i];
  if (where == ~std::uint64_t{0}) {
    std::memcpy(to, ones, rows);
    return;
  }
  for (std::size_t i = 0; i < rows; ++i)
    if ((where >> i & 1) != 0) to[i] = ones[i];
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
