// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/json.h"

#include <cctype>
#include <cmath>
#include <cstring>
#include <set>

#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/expected.h"
#include "catalogue/codec/nearest_double.h"

namespace touchstone::catalogue {
namespace {

constexpr char typed_number_mark = '\x01';
constexpr long most_decimal_exponent = 5000;
/// The deepest document of ours, a tally's smallest finding, is nested a dozen deep.
constexpr int most_nested = 64;
/// Objects keep their fields in a list, so that finding one takes time in proportion to it.
constexpr std::size_t most_fields = 1000;

bool starts_number(char c) { return c == '-' || c == '+' || c == '.' || (c >= '0' && c <= '9'); }

/// Every number outside a string becomes a marked string; what is between marks is checked when it is read.
std::string with_marked_numbers(const std::string& text) {
  std::string result;
  result.reserve(text.size() * 2);
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\' && i + 1 < text.size()) {
      (result += c) += text[++i];
    } else if (c == '"') {
      in_string = !in_string;
      result += c;
    } else if (!in_string && (starts_number(c) || c == 'N' || c == 'I')) {
      // NaN, Infinity, 0x1 or +1 are no JSON, but the complaint about them should name their field.
      result += "\"\\u0001";
      while (i < text.size() && (starts_number(text[i]) || std::isalpha(static_cast<unsigned char>(text[i])) != 0))
        result += text[i++];
      --i;
      result += '"';
    } else {
      result += c;
    }
  }
  return result;
}

/// A JSON number: -?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?
bool is_decimal(const std::string& text) {
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t first = i;
    while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
    return i - first;
  };
  if (i < text.size() && text[i] == '-') ++i;
  const bool zero_first = i < text.size() && text[i] == '0';
  const std::size_t whole = digits();
  if (whole == 0 || (zero_first && whole > 1)) return false;
  if (i < text.size() && text[i] == '.' && (++i, digits() == 0)) return false;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (digits() == 0) return false;
  }
  return i == text.size();
}

struct Token {
  std::string text;
  bool hexadecimal = false;
};

Token number_token(const Json& value, const std::string& field) {
  const auto no_number = [&] { return InvalidInput(field, expected("a number", value)); };
  if (!value.is_string()) throw no_number();
  std::string text = value.get<std::string>();
  if (!text.empty() && text[0] == typed_number_mark) {
    text.erase(0, 1);
    if (text == "NaN" || text == "Infinity" || text == "-Infinity") throw InvalidInput(field, "finite number");
    if (!is_decimal(text)) throw no_number();
    return {text, false};
  }
  const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  if (text.compare(sign, 2, "0x") != 0 && text.compare(sign, 2, "0X") != 0) throw no_number();
  std::string bare = (text[0] == '-' ? "-" : "") + text.substr(sign + 2);
  if (bare.size() == (text[0] == '-' ? 1u : 0u) || bare.back() == 'p' || bare.back() == 'P') throw no_number();
  return {bare, true};
}

double nearest(const Token& token, const std::string& field, const Json& typed) {
  const std::size_t sign = token.text[0] == '-' ? 1 : 0;
  const auto value = token.hexadecimal ? nearest_double((sign == 1 ? "-0x" : "0x") + token.text.substr(sign), true)
                                       : nearest_double(token.text);
  if (!value) throw InvalidInput(field, expected("a number", typed));
  if (std::isinf(*value)) throw InvalidInput(field, "finite number");
  return *value;
}

mpq_class power(unsigned base, long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, static_cast<unsigned long>(std::labs(exponent)));
  return exponent < 0 ? mpq_class(1, result) : mpq_class(result);
}

/// Every walk over a document calls itself for its parts: what is nested deeper never becomes one.
Json parsed(const std::string& text) {
  std::vector<std::set<std::string>> keys;
  const auto refuse = [&keys](int depth, Json::parse_event_t event, Json& parsed) {
    const bool opens = event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    if (opens && depth >= most_nested)
      throw InvalidInput("line", "nested at most " + std::to_string(most_nested) + " deep");
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && keys.back().size() == most_fields)
      throw InvalidInput("line", "at most " + std::to_string(most_fields) + " fields in an object");
    if (event == Json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second) {
      throw InvalidInput(excerpt(parsed.get_ref<const std::string&>(), most_of_a_key), "given once");
    }
    return true;
  };
  try {
    if (text.find('\0') != std::string::npos)
      throw InvalidInput("line", "one JSON object");  // the parser would end there
    return Json::parse(text, refuse);
  } catch (const nlohmann::json::exception&) {
    throw InvalidInput("line", "one JSON object");
  }
}

}  // namespace

Json parse_line(const std::string& text) { return parsed(with_marked_numbers(text)); }
Json parse_own_line(const std::string& text) { return parsed(text); }

bool is_typed_number(const Json& value) {
  return value.is_string() && !value.get_ref<const std::string&>().empty() &&
         value.get_ref<const std::string&>()[0] == typed_number_mark;
}

std::string typed_text(const Json& value) { return value.get_ref<const std::string&>().substr(1); }

double read_double(const Json& value, const std::string& field) {
  if (value.is_string()) {
    const std::string& text = value.get_ref<const std::string&>();
    if (text == "nan" || text == "inf" || text == "-inf") throw InvalidInput(field, "finite number");
  }
  return nearest(number_token(value, field), field, value);
}

double read_answer_number(const Json& value, const std::string& field) {
  if (value.is_null())
    throw InvalidInput(field,
                       R"(expected a number, got null (JSON has no NaN or infinity; send "nan", "inf", "-inf"))");
  if (value.is_string()) {
    const std::string text = is_typed_number(value) ? typed_text(value) : value.get<std::string>();
    const bool bare = is_typed_number(value);
    if (text == (bare ? "NaN" : "nan")) return std::nan("");
    if (text == (bare ? "Infinity" : "inf")) return HUGE_VAL;
    if (text == (bare ? "-Infinity" : "-inf")) return -HUGE_VAL;
  }
  try {
    return nearest(number_token(value, field), field, value);
  } catch (const InvalidInput& refused) {
    if (refused.rule() != "finite number") throw;
    return number_token(value, field).text[0] == '-' ? -HUGE_VAL : HUGE_VAL;
  }
}

bool read_flag(const Json& value, const std::string& field) {
  if (!value.is_boolean()) throw InvalidInput(field, expected("true or false", value));
  return value.get<bool>();
}

std::uint32_t read_index(const Json& value, const std::string& field) {
  const double number = read_double(value, field);
  if (!(number >= 0 && number < 0x1p32 && number == std::trunc(number)))
    throw InvalidInput(field, expected("a whole number below 2^32", value));
  return static_cast<std::uint32_t>(number);
}

mpq_class read_exact(const Json& value, const std::string& field) {
  const Token token = number_token(value, field);
  const std::string& text = token.text;
  const std::size_t mark = text.find_first_of(token.hexadecimal ? "pP" : "eE");
  const std::string exponent_text = mark == std::string::npos ? "0" : text.substr(mark + 1);
  errno = 0;
  long exponent = std::strtol(exponent_text.c_str(), nullptr, 10);
  if (errno != 0 || std::labs(exponent) > most_decimal_exponent)
    throw InvalidInput(field, "exponent between -5000 and 5000");
  std::string digits = text.substr(0, mark);
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1) * (token.hexadecimal ? 4 : 1);
    digits.erase(point, 1);
  }
  mpz_class whole;
  if (whole.set_str(digits, token.hexadecimal ? 16 : 10) != 0) throw InvalidInput(field, expected("a number", value));
  return mpq_class(whole) * power(token.hexadecimal ? 2 : 10, exponent);
}

Json written(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  if (value == std::trunc(value) && std::fabs(value) < 0x1p53 && !(value == 0 && std::signbit(value))) {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

Json written(const mpq_class& value) { return value.get_str(); }

std::string hexadecimal(double value) {
  if (!std::isfinite(value)) return decimal(value);
  char text[40];
  const int length = std::snprintf(text, sizeof text, "%a", value);
  return std::string(text, static_cast<std::size_t>(length));
}

std::string decimal(double value) {
  const Json json = written(value);
  return json.is_string() ? json.get<std::string>() : json.dump();
}

std::string one_line(const Json& value) { return value.dump(-1, ' ', true, Json::error_handler_t::replace); }

void require_fields(const Json& object, const std::string& path, std::initializer_list<const char*> names) {
  if (!object.is_object()) throw InvalidInput(path, expected("an object", object));
  for (const auto& [key, value] : object.items()) {
    bool known = false;
    for (const char* name : names) known = known || key == name;
    if (!known) throw InvalidInput(unknown_path(path, key), no_such_field(key, names));
  }
}

void require_array(const Json& value, const std::string& path, std::size_t size) {
  if (!value.is_array() || value.size() != size) {
    throw InvalidInput(path, expected("an array of " + std::to_string(size), value));
  }
}

std::string member_path(const std::string& path, const char* name) { return path.empty() ? name : path + "." + name; }

std::string unknown_path(const std::string& path, const std::string& key) {
  return member_path(path, excerpt(key, most_of_a_key).c_str());
}

}  // namespace touchstone::catalogue
