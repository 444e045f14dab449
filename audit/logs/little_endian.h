// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

/// Numbers in the binary form of a log: integers of seven bits a byte, the lowest first, and IEEE 754 numbers with
/// their lowest byte first, on every machine.
namespace touchstone::audit {

/// Thrown if bytes end before their content.
struct IncompleteBytes : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr std::size_t longest_varint = 10;

inline std::uint64_t take_varint(std::string_view& bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size() && i < longest_varint; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    value |= std::uint64_t{byte & 0x7fu} << (7 * i);
    if (byte < 0x80) {
      bytes.remove_prefix(i + 1);
      return value;
    }
  }
  throw IncompleteBytes("damaged: an integer has no end");
}

inline void append_varint(std::uint64_t value, std::string& bytes) {
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
  bytes += static_cast<char>(value);
}

template <class Bits>
Bits little_endian(const char* bytes) {
  Bits bits = 0;
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(&bits, bytes, sizeof bits);
  } else {
    for (std::size_t i = 0; i < sizeof bits; ++i) bits |= Bits{static_cast<unsigned char>(bytes[i])} << (8 * i);
  }
  return bits;
}

template <class Bits>
void append_little_endian(Bits bits, std::string& bytes) {
  for (std::size_t i = 0; i < sizeof bits; ++i) bytes += static_cast<char>(bits >> (8 * i));
}

/// Requires that the bytes are present.
inline void take_numbers(std::string_view& bytes, bool floats, double* numbers, std::size_t count) {
  const std::size_t size = floats ? 4 : 8;
  if (bytes.size() < size * count) throw IncompleteBytes("fewer bytes than the record says");
  for (std::size_t i = 0; i < count; ++i) {
    const char* const at = bytes.data() + size * i;
    numbers[i] = floats ? double{std::bit_cast<float>(little_endian<std::uint32_t>(at))}
                        : std::bit_cast<double>(little_endian<std::uint64_t>(at));
  }
  bytes.remove_prefix(size * count);
}

}  // namespace touchstone::audit
