// SPDX-License-Identifier: Apache-2.0
#include "audit/shell_quoted.h"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::audit {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// By printf, which produces the control characters: the word stays on one line.
std::string printed(const std::string& text) {
  std::string format;
  for (const char c : text) {
    if (is_control(c)) format += fmt::format("\\{:03o}", static_cast<unsigned>(c));
    else if (c == '\'') format += "'\\''";
    else if (c == '\\') format += "\\\\";
    else if (c == '%') format += "%%";
    else format += c;
  }
  return "\"$(printf '" + format + "')\"";
}

}  // namespace

std::string shell_quoted(const std::string& text) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+:,./-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  if (std::any_of(text.begin(), text.end(), is_control)) return printed(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

}  // namespace touchstone::audit
