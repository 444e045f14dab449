// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/nearest_double.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

namespace touchstone::catalogue {
namespace {

bool is_sign(char c) { return c == '-' || c == '+'; }

/// True if a number is at least 1: by the position of its first nonzero digit, moved by the exponent, of which
/// `units_a_digit` make a digit.
bool at_least_one(std::string_view text, const char* exponent_marks, long long units_a_digit) {
  const std::size_t e = std::min(text.find_first_of(exponent_marks), text.size());
  const std::string_view digits = text.substr(0, e);
  const std::size_t dot = std::min(digits.find('.'), digits.size()),
                    first = digits.find_first_of("123456789abcdefABCDEF");
  if (first == digits.npos) return false;
  const long long place = first < dot ? static_cast<long long>(dot - first) - 1 : -static_cast<long long>(first - dot);
  long long exponent = 0;
  if (e < text.size()) {
    std::string_view power = text.substr(e + 1);
    const bool negative = power.starts_with('-');
    if (is_sign(power[0])) power.remove_prefix(1);
    const long long huge = std::numeric_limits<long long>::max() / 2;
    if (std::from_chars(power.data(), power.data() + power.size(), exponent).ec != std::errc() || exponent > huge)
      exponent = huge;
    if (negative) exponent = -exponent;
  }
  return place * units_a_digit + exponent >= 0;
}

}  // namespace

std::optional<double> nearest_double(std::string_view text, bool hexadecimal_too) {
  const bool negative = text.starts_with('-');
  if (!text.empty() && is_sign(text[0])) text.remove_prefix(1);
  const bool hexadecimal = hexadecimal_too && (text.starts_with("0x") || text.starts_with("0X"));
  if (hexadecimal) text.remove_prefix(2);
  // from_chars also accepts "inf" and "-1".
  const std::string_view digits = hexadecimal ? "0123456789abcdefABCDEF" : "0123456789";
  const std::size_t first = text.starts_with('.') ? 1 : 0;
  if (first >= text.size() || digits.find(text[first]) == digits.npos) return std::nullopt;
  double value = 0;
  const auto format = hexadecimal ? std::chars_format::hex : std::chars_format::general;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value, format);
  if (stop != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const bool large = hexadecimal ? at_least_one(text, "pP", 4) : at_least_one(text, "eE", 1);
    value = large ? std::numeric_limits<double>::infinity() : 0.0;
  } else if (error != std::errc()) {
    return std::nullopt;
  }
  return negative ? -value : value;
}

}  // namespace touchstone::catalogue
