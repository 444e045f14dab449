// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/json.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit {

/// Longer than any text that an audit writes.
inline constexpr std::size_t most_of_a_text = 1000;

/// A value and its position in the file, so that a refusal can name it.
struct Place {
  const Json& value;
  std::string path;

  Place at(const char* name) const {
    const std::string field = member_path(path, name);
    if (!value.is_object()) throw InvalidInput(path.empty() ? "file" : path, "object");
    if (!value.contains(name)) throw InvalidInput(field, "missing");
    return {value[name], field};
  }
  template <class Visit>
  void each(const Visit& visit) const {
    if (!value.is_array()) throw InvalidInput(path, "array");
    for (std::size_t i = 0; i < value.size(); ++i) visit(Place{value[i], path + "[" + std::to_string(i) + "]"});
  }
  template <class Visit>
  void each_member(const Visit& visit) const {
    if (!value.is_object()) throw InvalidInput(path, "object");
    for (const auto& [key, part] : value.items()) visit(key, Place{part, unknown_path(path, key)});
  }
  std::string text() const {
    if (!value.is_string() || is_typed_number(value)) throw InvalidInput(path, "string");
    return excerpt(value.get_ref<const std::string&>(), most_of_a_text);
  }
  bool flag() const {
    if (!value.is_boolean()) throw InvalidInput(path, "true or false");
    return value.get<bool>();
  }
  double number() const { return read_answer_number(value, path); }
  std::uint64_t count() const {
    std::uint64_t n = 0;
    const std::string digits = is_typed_number(value) ? value.get<std::string>().substr(1) : "";
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
    if (digits.empty() || error != std::errc() || stop != digits.data() + digits.size())
      throw InvalidInput(path, "count");
    return n;
  }
  /// 16 digits.
  std::uint64_t hexadecimal() const {
    const std::string digits = text();
    std::uint64_t n = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n, 16);
    if (digits.size() != 16 || error != std::errc() || stop != digits.data() + digits.size())
      throw InvalidInput(path, "16 hexadecimal digits");
    return n;
  }
  std::size_t one_of(const std::vector<std::string>& words) const {
    const std::string word = text();
    std::string rule = "one of";
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (word == words[i]) return i;
      rule += (i == 0 ? " " : ", ") + words[i];
    }
    throw InvalidInput(path, rule);
  }
};

}  // namespace touchstone::audit
