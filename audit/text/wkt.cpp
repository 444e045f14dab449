// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>

#include "audit/text/geometries.h"
#include "catalogue/codec/excerpt.h"

namespace touchstone::audit {
namespace {

/// Reads WKT and returns the same as JSON, in which every number is as it was typed.
class Wkt {
 public:
  explicit Wkt(const std::string& text) : text_(text) {}

  std::string geometries() {
    std::string all = "[" + geometry();
    while (accept(';')) {
      if (peek() != '\0') all += "," + geometry();
    }
    if (peek() != '\0') refuse("a semicolon or the end of the line");
    return all + "]";
  }

 private:
  [[noreturn]] void refuse(const std::string& wanted) const {
    throw InvalidInput("line", "WKT: expected " + wanted + " at column " + std::to_string(at_ + 1));
  }

  [[noreturn]] void refuse_srid(std::size_t first) const {
    const std::size_t end = std::min(text_.find(';', first), text_.size() - 1);
    throw InvalidInput("line", "WKT: drop " + excerpt(text_.substr(first, end + 1 - first), most_of_a_key) +
                                   " at column " + std::to_string(first + 1) + ": coordinates are taken as they are");
  }

  /// The next character that is not a space; 0 at the end.
  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  /// A word in upper case; empty if the next character is not a letter.
  std::string word() {
    std::string found;
    for (peek(); at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0; ++at_)
      found += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_])));
    return found;
  }

  std::string geometry() {
    const std::size_t first = (peek(), at_);
    std::string keyword = word(), tag;
    if (keyword.empty()) refuse("the name of a geometry");
    if (keyword == "SRID" && peek() == '=') refuse_srid(first);
    for (const char* suffix : {"ZM", "Z", "M"}) {
      if (tag.empty() && keyword.ends_with(suffix)) tag = suffix, keyword.resize(keyword.size() - tag.size());
    }
    bool empty = false;
    if (peek() != '(') {
      std::string more = word();
      if (more == "Z" || more == "M" || more == "ZM") tag = more, more = word();
      empty = more == "EMPTY";
      if (!empty && peek() != '(') refuse("( or EMPTY");
    }
    if (tag.ends_with("M")) {
      at_ = first;
      refuse("no M coordinates");
    }
    const auto written = [&](const char* type, const std::string& coordinates) {
      return std::string(R"({"type":")") + type + R"(","coordinates":)" + coordinates + "}";
    };
    if (keyword == "POINT") return written("Point", empty ? "[]" : bracketed([this] { return position(); }));
    if (keyword == "LINESTRING") return written("LineString", empty ? "[]" : positions());
    if (keyword == "POLYGON") return written("Polygon", empty ? "[]" : list([this] { return positions(); }));
    if (keyword == "MULTIPOLYGON")
      return written("MultiPolygon", empty ? "[]" : list([this] { return list([this] { return positions(); }); }));
    if (keyword == "MULTIPOINT")
      return written("MultiPoint", empty ? "[]" : list([this] {
                       return peek() == '(' ? bracketed([this] { return position(); }) : position();
                     }));
    if (!empty) pass_over();
    return written(keyword.c_str(), "[]");
  }

  template <class Inner>
  std::string bracketed(const Inner& inner) {
    if (!accept('(')) refuse("(");
    std::string found = inner();
    if (!accept(')')) refuse(")");
    return found;
  }
  template <class Item>
  std::string list(const Item& item) {
    return "[" + bracketed([&] {
             std::string all = item();
             while (accept(',')) all += "," + item();
             return all;
           }) +
           "]";
  }
  std::string positions() {
    return list([this] { return position(); });
  }

  std::string position() {
    std::string found = "[" + number();
    while (peek() != ',' && peek() != ')' && peek() != '\0') found += "," + number();
    return found + "]";
  }

  /// In JSON's form: without a plus, with a digit on either side of the point. Text that is not a number is refused if
  /// its field is known.
  std::string number() {
    static const std::string signs = "+-.";
    const char c = peek();
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 && signs.find(c) == std::string::npos) refuse("a number");
    std::string found;
    for (; at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || signs.find(text_[at_]) != std::string::npos);
         ++at_)
      found += text_[at_];
    const auto digit = [&found](std::size_t i) {
      return i < found.size() && std::isdigit(static_cast<unsigned char>(found[i])) != 0;
    };
    if (found[0] == '+' && (digit(1) || (found[1] == '.' && digit(2)))) found.erase(0, 1);
    const std::size_t point = found.find('.');
    if (point == std::string::npos) return found;
    const bool before = point > 0 && digit(point - 1), after = digit(point + 1);
    if (before && !after) found.insert(point + 1, "0");
    if (after && !before) found.insert(point, "0");
    return found;
  }

  /// Skips the brackets of a geometry that no field accepts.
  void pass_over() {
    int depth = 0;
    do {
      if (at_ == text_.size()) refuse(")");
      depth += (text_[at_] == '(') - (text_[at_] == ')');
      ++at_;
    } while (depth > 0);
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

Json geometries_of_wkt(const std::string& line) { return parse_line(Wkt(line).geometries()); }

}  // namespace touchstone::audit
