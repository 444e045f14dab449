// SPDX-License-Identifier: Apache-2.0
#include "report/words/formula.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace touchstone::report {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string element(const std::string& name, const std::string& inside) {
  return "<" + name + ">" + inside + "</" + name + ">";
}

/// Words between formulas, which are not names.
bool is_word(const std::string& name) {
  constexpr const char* words[] = {"and", "or", "if", "else", "where", "for", "with",
                                   "is",  "on", "of", "each", "all",   "in"};
  return std::find(std::begin(words), std::end(words), name) != std::end(words);
}

/// One without another meaning: `min`, `center`, `left`.
bool is_long_name(const std::string& name) {
  return name.size() > 2 && std::count_if(name.begin(), name.end(), is_digit) == 0;
}

class Formula {
 public:
  explicit Formula(const std::string& text) : text_(text) {}

  std::optional<std::string> mathml() {
    const std::string inside = row('\0');
    if (failed_ || at_ != text_.size() || text_.find_first_of("=<>") == std::string::npos) return std::nullopt;
    return "<math display=\"block\">" + inside + "</math>";
  }

 private:
  struct Item {
    std::string html;
    std::string inner;  ///< without its parentheses, if any
    const std::string& bare() const { return inner.empty() ? html : inner; }
  };

  char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  char after(std::size_t n) const { return at_ + n < text_.size() ? text_[at_ + n] : '\0'; }
  void skip_spaces() {
    while (now() == ' ') ++at_;
  }

  /// Reads up to the closing character, which stays, or the end.
  std::string row(char closing) {
    std::vector<Item> items;
    std::size_t product = 0;  // start of the product that a `/` would divide
    bool long_name_before = false;
    for (skip_spaces(); !failed_ && now() != '\0' && now() != closing; skip_spaces()) {
      const std::size_t begun = at_;
      if (now() == '/') {
        ++at_;
        divide(items, product);
      } else if (now() == '^') {
        ++at_;
        raise(items);
      } else if (const std::string sign = read_sign(!items.empty()); !sign.empty()) {
        items.push_back({sign, ""});
        if (!stays_in_product_) product = items.size();
      } else {
        const std::string name = name_here();
        const bool long_name = is_long_name(name) && !is_word(name) && after(name.size()) != '(';
        if (long_name && long_name_before) failed_ = true;  // prose
        long_name_before = long_name;
        if (is_word(name)) {
          at_ += name.size();
          items.push_back({"<mtext>&#160;" + name + "&#160;</mtext>", ""});
          product = items.size();
        } else {
          items.push_back(factor());
        }
        if (at_ == begun) failed_ = true;
        continue;
      }
      long_name_before = false;
    }
    std::string html;
    for (const Item& item : items) html += item.html;
    return html;
  }

  void divide(std::vector<Item>& items, std::size_t product) {
    if (items.size() <= product) failed_ = true;
    if (failed_) return;
    std::string above;
    for (std::size_t i = product; i < items.size(); ++i) above += items[i].html;
    if (items.size() == product + 1) above = items[product].bare();
    skip_spaces();
    const Item below = factor();
    items.resize(product);
    items.push_back({element("mfrac", element("mrow", above) + element("mrow", below.bare())), ""});
  }

  void raise(std::vector<Item>& items) {
    if (items.empty()) failed_ = true;
    if (failed_) return;
    std::string sign;
    if (now() == '-') sign = "<mo>\u2212</mo>", ++at_;
    const Item power = factor();
    items.back() = {element("msup", element("mrow", items.back().html) + element("mrow", sign + power.bare())), ""};
  }

  /// The operator between factors or sums; empty if there is none, and then nothing is read.
  std::string read_sign(bool follows_something) {
    struct Sign {
      const char *text, *shown;
      bool of_product;
    };
    constexpr Sign signs[] = {{"<=", "\u2264", false}, {">=", "\u2265", false}, {"!=", "\u2260", false},
                              {"->", "\u2192", false}, {"<", "&lt;", false},    {">", "&gt;", false},
                              {"=", "=", false},       {"+", "+", false},       {"-", "\u2212", false},
                              {",", ",", false},       {";", ";", false},       {":", ":", false},
                              {". ", "\u22c5", true},  {"x ", "\u00d7", true},  {"*", "\u22c5", true}};
    for (const Sign& sign : signs) {
      const std::string text = sign.text;
      if (text_.compare(at_, text.size(), text) != 0) continue;
      if (text == "x " && !(follows_something && at_ > 0 && text_[at_ - 1] == ' ' && begins_factor(after(2)))) continue;
      if (text == ". " && !follows_something) continue;
      at_ += text.size();
      stays_in_product_ = sign.of_product;
      const bool ends = text == "," || text == ";";
      return element("mo", sign.shown) + (ends ? "<mspace width=\"0.6em\"></mspace>" : "");
    }
    if (now() == '.' && at_ + 1 == text_.size()) {  // of a sentence
      ++at_;
      return element("mo", ".");
    }
    return "";
  }

  static bool begins_factor(char c) { return is_letter(c) || is_digit(c) || c == '(' || c == '|' || c == '['; }

  std::string name_here() const {
    std::size_t end = at_;
    if (!is_letter(now())) return "";
    while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]) || text_[end] == '_')) ++end;
    return text_.substr(at_, end - at_);
  }

  Item factor() {
    if (is_digit(now())) return number();
    if (is_letter(now())) return named();
    if (now() == '(') return grouped(')', "(", ")");
    if (now() == '[') return grouped(']', "[", "]");
    if (now() == '|') {
      Item item = grouped('|', "|", "|");
      return {item.html, ""};  // its bars are no parentheses
    }
    failed_ = true;
    return {};
  }

  Item grouped(char closing, const char* open, const char* close) {
    ++at_;
    const std::string inside = row(closing);
    if (now() != closing) failed_ = true;
    ++at_;
    return {element("mrow", element("mo", open) + inside + element("mo", close)), closing == ')' ? inside : ""};
  }

  Item number() {
    const std::size_t begun = at_;
    while (is_digit(now()) || (now() == '.' && is_digit(after(1)))) ++at_;
    return {element("mn", text_.substr(begun, at_ - begun)), ""};
  }

  /// A name with its indices and primes, and its argument.
  Item named() {
    const std::string name = name_here();
    at_ += name.size();
    if (name == "sqrt" && now() == '(') {
      const Item inside = grouped(')', "(", ")");
      return {element("msqrt", inside.bare()), ""};
    }
    const bool short_one = name.size() == 2 || (name.size() > 2 && std::all_of(name.begin() + 1, name.end(), is_digit));
    std::string base = element("mi", short_one ? name.substr(0, 1) : name), index;
    if (short_one) index = element(is_digit(name[1]) ? "mn" : "mi", name.substr(1));
    while (now() == '.' && is_letter(after(1))) {
      ++at_;
      const std::string part = name_here();
      at_ += part.size();
      index += (index.empty() ? "" : "<mo>,</mo>") + element("mi", part);
    }
    if (now() == '[') {
      ++at_;
      index += (index.empty() ? "" : "<mo>,</mo>") + row(']');
      if (now() != ']') failed_ = true;
      ++at_;
    }
    std::string primes;
    for (; now() == '\''; ++at_) primes += "\u2032";
    const std::string marks = primes.empty() ? "" : element("mo", primes);
    if (!index.empty() && !marks.empty()) base = element("msubsup", base + element("mrow", index) + marks);
    else if (!index.empty()) base = element("msub", base + element("mrow", index));
    else if (!marks.empty()) base = element("msup", base + marks);
    if (now() == '(') base = element("mrow", base + grouped(')', "(", ")").html);
    return {base, ""};
  }

  const std::string& text_;
  std::size_t at_ = 0;
  bool failed_ = false, stays_in_product_ = false;
};

}  // namespace

std::optional<std::string> formula_in_mathml(const std::string& text) { return Formula(text).mathml(); }

}  // namespace touchstone::report
