// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_packed.h"

#include <array>
#include <bit>
#include <string_view>

namespace touchstone::certify {
namespace {

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t no_letter = 64;

const std::array<std::uint8_t, 256>& values() {
  static const auto table = [] {
    std::array<std::uint8_t, 256> all{};
    all.fill(no_letter);
    for (std::size_t k = 0; k < letters.size(); ++k)
      all[static_cast<unsigned char>(letters[k])] = static_cast<std::uint8_t>(k);
    return all;
  }();
  return table;
}

/// Every 24 bits are four letters; in the last group, letters without bits are '=', and bits beyond the bytes are 0.
std::vector<std::uint8_t> bytes_of(const std::string& text, const std::string& malformed) {
  expect(text.size() % 4 == 0, malformed);
  const std::size_t filled = text.ends_with("==")  ? text.size() - 2
                             : text.ends_with('=') ? text.size() - 1
                                                   : text.size();
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t held = 0;
  int bits = 0;
  for (std::size_t k = 0; k < filled; ++k) {
    const std::uint8_t value = values()[static_cast<unsigned char>(text[k])];
    expect(value != no_letter, malformed);
    held = held << 6 | value, bits += 6;
    if (bits >= 8) bits -= 8, bytes.push_back(static_cast<std::uint8_t>(held >> bits));
    held &= 0xffU;
  }
  expect((held & ((1U << bits) - 1)) == 0, malformed);
  return bytes;
}

template <class Number>
std::vector<Number> numbers_of(const std::vector<std::uint8_t>& bytes) {
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  for (std::size_t n = 0; n < numbers.size(); ++n)
    for (std::size_t k = 0; k < sizeof(Number); ++k)
      numbers[n] |= static_cast<Number>(bytes[n * sizeof(Number) + k]) << (8 * k);
  return numbers;
}

template <class Number>
std::string packed_numbers(const std::vector<Number>& numbers) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(numbers.size() * sizeof(Number));
  for (const Number number : numbers)
    for (std::size_t k = 0; k < sizeof(Number); ++k) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * k)));
  return packed(bytes);
}

std::vector<std::uint8_t> bytes_in(const json& value, const std::string& what, std::size_t size) {
  const std::string malformed = what + ": base64 of " + std::to_string(size) + " bytes an element";
  expect(value.is_string(), malformed);
  std::vector<std::uint8_t> bytes = bytes_of(value.get_ref<const std::string&>(), malformed);
  expect(bytes.size() % size == 0, malformed);
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> packed_bytes(const json& value, const std::string& what) { return bytes_in(value, what, 1); }
std::vector<std::uint32_t> packed_indices(const json& value, const std::string& what) {
  return numbers_of<std::uint32_t>(bytes_in(value, what, 4));
}
std::vector<double> packed_doubles(const json& value, const std::string& what) {
  std::vector<double> numbers;
  for (const std::uint64_t bits : numbers_of<std::uint64_t>(bytes_in(value, what, 8)))
    numbers.push_back(std::bit_cast<double>(bits));
  return numbers;
}

std::string packed(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t held = 0;
    for (std::size_t b = 0; b < 3; ++b) held = held << 8 | (k + b < bytes.size() ? bytes[k + b] : 0U);
    for (std::size_t l = 0; l < 4; ++l) text += k + l <= bytes.size() ? letters[held >> (18 - 6 * l) & 63U] : '=';
  }
  return text;
}
std::string packed(const std::vector<std::uint32_t>& indices) { return packed_numbers(indices); }
std::string packed(const std::vector<double>& numbers) {
  std::vector<std::uint64_t> bits;
  bits.reserve(numbers.size());
  for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return packed_numbers(bits);
}

}  // namespace touchstone::certify
