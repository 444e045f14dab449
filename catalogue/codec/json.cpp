// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/json.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

#include "catalogue/codec/document.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/expected.h"
#include "catalogue/codec/nearest_double.h"

namespace touchstone::catalogue {
namespace {

constexpr char typed_number_mark = '\x01';
constexpr std::int64_t most_decimal_exponent = 5000;
/// Our deepest document, a tally's smallest finding, is nested a dozen deep.
constexpr std::size_t most_nested = 64;
/// Objects keep their fields in a list, so that finding a field takes linear time.
constexpr std::size_t most_fields = 1000;

bool starts_number(char c) { return c == '-' || c == '+' || c == '.' || (c >= '0' && c <= '9'); }

/// Turns every number outside a string into a marked string; the text between marks is checked when it is read.
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
      // NaN, Infinity, 0x1 and +1 are not JSON, but the complaint about them should name their field.
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

mpq_class power(unsigned base, std::int64_t exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, static_cast<std::uint64_t>(std::abs(exponent)));
  return exponent < 0 ? mpq_class(1, result) : mpq_class(result);
}

/// Builds a document. Every traversal of one is recursive, so documents nested more deeply are refused. (The library's
/// own parser, if given a callback, examines all elements of a list after each.)
class Builder {
 public:
  Json built() { return std::move(built_); }
  /// The number of characters read when the text ceased to be JSON.
  std::size_t read() const { return read_; }

  bool null() { return added(nullptr); }
  bool boolean(bool value) { return added(value); }
  bool number_integer(Json::number_integer_t value) { return added(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return added(value); }
  bool number_float(Json::number_float_t value, const std::string&) { return added(value); }
  bool string(std::string& value) { return added(std::move(value)); }
  bool binary(Json::binary_t& value) { return added(std::move(value)); }
  bool start_object(std::size_t) { return opened(Json::object()); }
  bool start_array(std::size_t) { return opened(Json::array()); }
  bool end_object() { return closed(); }
  bool end_array() { return closed(); }
  bool key(std::string& name) {
    Json& object = *open_.back();
    if (object.size() == most_fields)
      throw InvalidInput("line", "at most " + std::to_string(most_fields) + " fields in an object");
    if (object.contains(name)) throw InvalidInput(path_of(name), "given once");
    field_ = &object[name];
    return true;
  }
  bool parse_error(std::size_t read, const std::string&, const nlohmann::json::exception&) {
    read_ = read;
    return false;
  }

 private:
  /// The way from the document to a key of the innermost object.
  std::string path_of(const std::string& name) const {
    std::string path;
    const auto add = [&path](const std::string& key) {
      path += (path.empty() ? "" : ".") + excerpt(key, most_of_a_key);
    };
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const Json &outer = *open_[i], *const inner = open_[i + 1];
      if (outer.is_array()) path += "[" + std::to_string(outer.size() - 1) + "]";
      else add(std::find_if(outer.begin(), outer.end(), [inner](const Json& value) { return &value == inner; }).key());
    }
    add(name);
    return path;
  }
  Json& place_of(Json value) {
    if (open_.empty()) return built_ = std::move(value);
    Json& outer = *open_.back();
    if (outer.is_object()) return *field_ = std::move(value);
    outer.push_back(std::move(value));
    return outer.back();
  }
  bool added(Json value) {
    place_of(std::move(value));
    return true;
  }
  bool opened(Json empty) {
    if (open_.size() >= most_nested)
      throw InvalidInput("line", "nested at most " + std::to_string(most_nested) + " deep");
    open_.push_back(&place_of(std::move(empty)));
    return true;
  }
  bool closed() {
    open_.pop_back();
    return true;
  }

  Json built_;
  std::vector<Json*> open_;  ///< objects and lists that are still open, the innermost last
  Json* field_ = nullptr;    ///< the field whose value comes next
  std::size_t read_ = 0;
};

/// Thrown for a text that is not JSON, from that character on.
struct NoJson {
  std::size_t at;
};

Json parsed(const std::string& text) {
  if (const std::size_t end = text.find('\0'); end != std::string::npos)
    throw NoJson{end};  // the parser would end there
  Builder builder;
  if (!Json::sax_parse(text, &builder)) throw NoJson{std::max<std::size_t>(builder.read(), 1) - 1};
  return builder.built();
}

/// The position in the typed text of a character of the marked text.
std::size_t typed_place(const std::string& text, std::size_t marked_place) {
  std::size_t low = 0, high = text.size() + 1;  // this many characters, once marked, end before it; and do not
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (with_marked_numbers(text.substr(0, middle)).size() > marked_place ? high : low) = middle;
  }
  return low;
}

/// The first place at which a text is not JSON, and what stands there.
struct Refusal {
  std::size_t line;
  std::string place;  ///< "line 3, column 21", both from 1; a column is a byte
  std::string rule;
};

Refusal no_json(const std::string& text, std::size_t place) {
  const auto of_number = [&](std::size_t i) {
    return starts_number(text[i]) || std::isalnum(static_cast<unsigned char>(text[i])) != 0;
  };
  while (place > 0 && place < text.size() && of_number(place) && of_number(place - 1)) --place;
  const std::size_t line = 1 + std::count(text.begin(), text.begin() + place, '\n'),
                    before = place == 0 ? std::string::npos : text.rfind('\n', place - 1),
                    column = place - (before == std::string::npos ? 0 : before + 1) + 1,
                    last = place == 0 ? std::string::npos : text.find_last_not_of(" \t\r\n", place - 1);
  const std::string found =
      place < text.size() ? "unexpected \"" + excerpt(text.substr(place, 1), 1) + "\"" : "the text ends";
  const bool comma = last != std::string::npos && text[last] == ',';
  return {line, "line " + std::to_string(line) + ", column " + std::to_string(column),
          "not JSON: " + found + (comma ? " after a comma" : "")};
}

InvalidInput no_json_in_line(const std::string& text, std::size_t place) {
  const auto [line, at, rule] = no_json(text, place);
  return {"line", rule + " in " + (line == 1 ? at.substr(std::strlen("line 1, ")) : at)};
}

}  // namespace

Json parse_line(const std::string& text) {
  try {
    return parsed(with_marked_numbers(text));
  } catch (const NoJson& from) {
    throw no_json_in_line(text, typed_place(text, from.at));
  }
}

Json parse_own_line(const std::string& text) {
  try {
    return parsed(text);
  } catch (const NoJson& from) {
    throw no_json_in_line(text, from.at);
  }
}

Json parse_document(const std::string& text) {
  try {
    return parsed(with_marked_numbers(text));
  } catch (const NoJson& from) {
    const Refusal refusal = no_json(text, typed_place(text, from.at));
    throw InvalidInput(refusal.place, refusal.rule);
  }
}

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
    throw InvalidInput(field, expected("an integer below 2^32", value));
  return static_cast<std::uint32_t>(number);
}

mpq_class read_exact(const Json& value, const std::string& field) {
  const Token token = number_token(value, field);
  const std::string& text = token.text;
  const std::size_t mark = text.find_first_of(token.hexadecimal ? "pP" : "eE");
  const std::string exponent_text = mark == std::string::npos ? "0" : text.substr(mark + 1);
  errno = 0;
  std::int64_t exponent = std::strtoll(exponent_text.c_str(), nullptr, 10);
  if (errno != 0 || std::abs(exponent) > most_decimal_exponent)
    throw InvalidInput(field, "exponent between -5000 and 5000");
  std::string digits = text.substr(0, mark);
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<std::int64_t>(digits.size() - point - 1) * (token.hexadecimal ? 4 : 1);
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
