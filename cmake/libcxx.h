// SPDX-License-Identifier: Apache-2.0
// What the tree uses of C++20 and libc++ does not have yet: it is included before every file.
#pragma once
#ifdef __cplusplus
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace std {

#if _LIBCPP_VERSION < 14000
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

/// The fewest digits that read back, in scientific notation or, unless that is asked for, the shorter notation. Fifteen
/// digits of a normal number are those of any shorter decimal that reads as it, and zeros.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format = chars_format::general) {
  char text[32];
  for (int digits = fabs(value) < 0x1p-1022 ? 0 : 14; digits < 17; ++digits) {
    snprintf(text, sizeof text, "%.*e", digits, value);
    if (strtod(text, nullptr) == value) break;
  }
  string shortest = text;
  size_t mark = shortest.find('e');
  if (shortest.find('.') != string::npos) {
    const size_t last_digit = shortest.find_last_not_of('0', mark - 1);
    const size_t kept = shortest[last_digit] == '.' ? last_digit : last_digit + 1;
    shortest.erase(kept, mark - kept);
    mark = kept;
  }
  if (format != chars_format::scientific) {
    const int exponent = atoi(shortest.c_str() + mark + 1), sign = value < 0, point = mark > 2u + sign;
    const int digits = static_cast<int>(mark) - sign - point;
    const int after_point = digits - 1 - exponent > 0 ? digits - 1 - exponent : 0;
    if (exponent > -8 && exponent < 24) {
      snprintf(text, sizeof text, "%.*f", after_point, value);
      if (strlen(text) <= shortest.size()) shortest = text;
    }
  }
  if (static_cast<size_t>(last - first) < shortest.size()) return {last, errc::value_too_large};
  memcpy(first, shortest.data(), shortest.size());
  return {first + shortest.size(), errc()};
}
#endif

#if _LIBCPP_VERSION < 200000
inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format format = chars_format::general) {
  const size_t sign = first != last && *first == '-' ? 1 : 0, prefix = format == chars_format::hex ? 2 : 0;
  string text(first, last);
  // strtod also reads blanks, a plus and, in decimals, a hexadecimal number.
  if (sign == text.size() || isspace(static_cast<unsigned char>(text[sign])) || strchr("+-", text[sign]) != nullptr)
    return {first, errc::invalid_argument};
  if (prefix != 0) text.insert(sign, "0x");
  else if (const size_t x = text.find_first_of("xX"); x != string::npos) text.resize(x);
  char* stop = nullptr;
  const double read = strtod(text.c_str(), &stop);
  const size_t consumed = static_cast<size_t>(stop - text.c_str());
  if (consumed <= sign + prefix) return {first, errc::invalid_argument};
  const char* const end = first + (consumed - prefix);
  if (isinf(read) && strchr("iI", text[sign]) == nullptr) return {end, errc::result_out_of_range};
  value = read;
  return {end, errc()};
}
#endif

}  // namespace std
#endif
