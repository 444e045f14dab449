// SPDX-License-Identifier: Apache-2.0
#include "robust/c/answered.h"

#include <charconv>
#include <cstring>

namespace touchstone::robust::c {
namespace {

template <std::size_t size>
void copy(std::string_view text, char (&place)[size]) {
  const std::size_t length = text.size() < size ? text.size() : size - 1;
  std::memcpy(place, text.data(), length);
  place[length] = 0;
}

}  // namespace

int failed(touchstone_error* error, touchstone_code code, std::string_view field, std::string_view rule) noexcept {
  if (error == nullptr) return code;
  error->question = TOUCHSTONE_NO_QUESTION;
  constexpr std::string_view row = "questions[";
  if (field.starts_with(row)) {
    const char* const end = field.data() + field.size();
    const auto [after, wrong] = std::from_chars(field.data() + row.size(), end, error->question);
    if (wrong == std::errc() && end - after > 2 && after[0] == ']' && after[1] == '.') {
      field.remove_prefix(static_cast<std::size_t>(after + 2 - field.data()));
    } else {
      error->question = TOUCHSTONE_NO_QUESTION;
    }
  }
  copy(field, error->field);
  copy(rule, error->rule);
  return code;
}

}  // namespace touchstone::robust::c
