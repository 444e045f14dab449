// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <exception>
#include <iosfwd>

namespace touchstone {

/// Input outside the contract: thrown by `robust` and `oracle` in every build type. Names the field as it is written in
/// JSON ("a[0][1]", "ray.direction") and the rule that it breaks ("finite number"). This header includes neither
/// <string> nor <stdexcept>, which would be most of what an operation's header includes.
class InvalidInput : public std::exception {
 public:
  /// Each is a std::string, or characters up to a zero.
  template <class Field, class Rule>
  InvalidInput(const Field& field, const Rule& rule) : text_(joined(characters(field), characters(rule))) {}
  InvalidInput(const InvalidInput& other) : text_(joined(other.text_, other.rule_text())) {}
  InvalidInput& operator=(const InvalidInput& other) {
    if (this != &other) {
      char* const copy = joined(other.text_, other.rule_text());
      delete[] text_;
      text_ = copy;
    }
    return *this;
  }
  ~InvalidInput() override { delete[] text_; }

  /// A caller includes <string>.
  template <class String = std::string>
  String field() const {
    return text_;
  }
  template <class String = std::string>
  String rule() const {
    return rule_text();
  }
  /// "field: rule"
  const char* what() const noexcept override { return text_ + std::strlen(text_) + 1; }

 private:
  static constexpr const char* between = ": ";

  const char* rule_text() const { return what() + std::strlen(text_) + std::strlen(between); }
  template <class Text>
  static const char* characters(const Text& text) {
    if constexpr (requires { text.c_str(); }) return text.c_str();
    else return text;
  }
  /// The field and a zero, then what() and a zero.
  static char* joined(const char* field, const char* rule) {
    const std::size_t length = std::strlen(field) + 1;
    char* const text = new char[2 * length + std::strlen(between) + std::strlen(rule)];
    std::strcpy(text, field);
    std::strcat(std::strcat(std::strcpy(text + length, field), between), rule);
    return text;
  }

  char* text_;
};

}  // namespace touchstone
