// SPDX-License-Identifier: Apache-2.0
// The strtod of MinGW-w64 does not round to nearest: it reads 2.386669033984066e-153, which is less than 2^-507, as
// 2^-507. nlohmann-json reads numbers by strtod, so a program for Windows has this one: the linker finds it first.
#include <charconv>
#include <cstring>

extern "C" long double __strtold(const char* text, char** end);

/// Decimal numbers in the range of double are read to nearest. Spaces, signs, words, 0x and numbers out of range are
/// left to MinGW-w64.
extern "C" double __mingw_strtod(const char* text, char** end) {
  const char* const digits = text + (*text == '-' ? 1 : 0);
  double value = 0;
  if (*digits < '0' || *digits > '9' || digits[1] == 'x' || digits[1] == 'X')
    return static_cast<double>(__strtold(text, end));
  const auto [stop, error] = std::from_chars(text, text + std::strlen(text), value);
  if (error != std::errc()) return static_cast<double>(__strtold(text, end));
  if (end != nullptr) *end = const_cast<char*>(stop);
  return value;
}

/// Its name in inline functions of the system's headers.
extern "C" double __strtod(const char* text, char** end) { return __mingw_strtod(text, end); }
