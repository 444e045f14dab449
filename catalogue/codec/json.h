// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <nlohmann/json.hpp>
#include <string>

#include "catalogue/codec/walk.h"
#include "geometry/invalid_input.h"

/// JSON as the program speaks it. Numbers inside a parsed line are kept as they were typed until a reader asks for a
/// double or for the decimal itself.
namespace touchstone::audit {

using Json = nlohmann::ordered_json;

/// Parses one line. Every number arrives as a `typed number` (see `is_typed_number`), so that 1e999 can be reported by its
/// field and 0.1 read as one tenth. Throws InvalidInput{"line", "JSON object"} with the position on malformed text.
Json parse_line(const std::string& text);

bool is_typed_number(const Json& value);
/// Its characters as they were typed, a number or not.
std::string typed_text(const Json& value);

/// The double nearest to what was typed: a decimal or a hexadecimal float string. Throws InvalidInput naming the field.
double read_double(const Json& value, const std::string& field);
/// The same, and "nan", "inf", "-inf" are let through, the bare words NaN, Infinity, -Infinity, and decimals beyond the
/// greatest double: an engine may answer them.
double read_answer_number(const Json& value, const std::string& field);
/// What was typed as an exact rational, before any rounding.
mpq_class read_exact(const Json& value, const std::string& field);

/// A double: an integer where it is one below 2^53, else the shortest decimal that reads back; "nan", "inf", "-inf".
Json written(double value);
inline Json written(const Json& value) { return value; }
/// "p/q" or "p".
Json written(const mpq_class& value);
std::string hexadecimal(double value);
/// One number in text, as it stands in `written`.
std::string decimal(double value);

/// One line, keys in the order of insertion, no spaces.
std::string one_line(const Json& value);

template <class T>
Json to_json(const T& value) {
  if constexpr (Enumeration<T>) {
    return Words<T>::words[static_cast<std::size_t>(value)];
  } else if constexpr (Plain<T>) {
    return value;
  } else if constexpr (is_bare<T>) {
    return to_json(value.*std::get<0>(Described<T>::members).pointer);
  } else if constexpr (Composite<T>) {
    Json result = Described<T>::form == Form::list ? Json::array() : Json::object();
    for_each_member<T>([&](const auto& member) {
      const auto& part = value.*member.pointer;
      if constexpr (is_optional<std::remove_cvref_t<decltype(part)>>) {
        if (part) result[member.name] = to_json(*part);
      } else if constexpr (Described<T>::form == Form::list) {
        result.push_back(to_json(part));
      } else {
        result[member.name] = to_json(part);
      }
    });
    return result;
  } else if constexpr (is_vector<T>) {
    Json result = Json::array();
    for (const auto& element : value) result.push_back(to_json(element));
    return result;
  } else {
    return written(value);
  }
}

/// Refuses what is not an object with exactly these fields, naming the field that is missing or not known.
void require_fields(const Json& object, const std::string& path, std::initializer_list<const char*> names);
void require_array(const Json& value, const std::string& path, std::size_t size);
std::string member_path(const std::string& path, const char* name);

bool read_flag(const Json& value, const std::string& field);
/// A whole number 0 <= n < 2^32.
Index read_index(const Json& value, const std::string& field);

/// Reads a value of type T; `read_number(json, path)` gives its numbers. Throws InvalidInput naming the path and the rule.
template <class T, class ReadNumber>
void read(const Json& json, const std::string& path, T& value, const ReadNumber& read_number) {
  if constexpr (Enumeration<T>) {
    std::string rule;
    for (std::size_t i = 0; i < Words<T>::words.size(); ++i) {
      if (json.is_string() && json.get_ref<const std::string&>() == Words<T>::words[i]) {
        value = static_cast<T>(i);
        return;
      }
      rule += (i == 0 ? "one of " : ", ") + std::string(Words<T>::words[i]);
    }
    throw InvalidInput(path, rule);
  } else if constexpr (std::is_same_v<T, bool>) {
    value = read_flag(json, path);
  } else if constexpr (Plain<T>) {
    value = read_index(json, path);
  } else if constexpr (is_bare<T>) {
    read(json, path, value.*std::get<0>(Described<T>::members).pointer, read_number);
  } else if constexpr (Composite<T>) {
    constexpr std::size_t size = std::tuple_size_v<decltype(Described<T>::members)>;
    if constexpr (Described<T>::form == Form::list) {
      require_array(json, path, size);
      std::size_t i = 0;
      for_each_member<T>([&](const auto& member) {
        read(json[i], path + "[" + std::to_string(i) + "]", value.*member.pointer, read_number);
        ++i;
      });
    } else {
      std::apply([&](const auto&... member) { require_fields(json, path, {member.name...}); }, Described<T>::members);
      for_each_member<T>([&](const auto& member) {
        if (json.contains(member.name)) {
          read(json[member.name], member_path(path, member.name), value.*member.pointer, read_number);
        } else if (!may_be_left_out<std::remove_cvref_t<decltype(value.*member.pointer)>>) {
          throw InvalidInput(member_path(path, member.name), "missing");
        }
      });
    }
  } else if constexpr (is_optional<T>) {
    read(json, path, value.emplace(), read_number);
  } else if constexpr (is_vector<T>) {
    if (!json.is_array()) throw InvalidInput(path, "array");
    value.resize(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
      read(json[i], path + "[" + std::to_string(i) + "]", value[i], read_number);
    }
  } else {
    value = read_number(json, path);
  }
}

}  // namespace touchstone::audit
