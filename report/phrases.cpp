// SPDX-License-Identifier: Apache-2.0
#include "report/phrases.h"

#include <algorithm>

#include "report/wording.h"

namespace touchstone::report {
namespace {

/// How an enumerator is worded. `beside`: of those types alone that have that other enumerator too.
struct Phrase {
  const char *word, *words, *beside = nullptr;
};

constexpr Phrase phrases[] = {
    {"left", "left of the line"},
    {"on", "on it"},
    {"off", "not on it"},
    {"right", "right of the line"},
    {"above", "above it"},
    {"below", "below it"},
    {"front", "in front of the plane"},
    {"back", "behind the plane"},
    {"boundary", "on the boundary"},
    {"same", "the same line"},
    {"parallel", "parallel lines"},
    {"crossing", "lines that cross"},
    {"disjoint", "no common point", "overlap"},
    {"disjoint", "apart"},
    {"touching", "just touching"},
    {"point", "a common point"},
    {"overlap", "an overlap"},
    {"none", "no orientation", "ccw"},
    {"none", "no hit"},
    {"hit", "a hit"},
    {"never", "no hit"},
    {"not_simple", "crossing itself"},
    {"proper", "with a normal"},
    {"degenerate", "without a normal", "proper"},
    {"ccw", "counter-clockwise"},
    {"cw", "clockwise"},
    {"true", "yes"},
    {"false", "no"},
};

std::string in_parentheses(const Json& numbers) {
  std::string text;
  for (const Json& number : numbers) {
    text += text.empty() ? "(" : ", ";
    text += number.is_string() ? number.get<std::string>() : one_line(number);
  }
  return text + ")";
}

bool is_tuple(const Json& value) {
  return value.is_array() && !value.empty() && value.size() <= 3 &&
         std::none_of(value.begin(), value.end(), [](const Json& part) { return part.is_structured(); });
}

/// Adds what a field holds; false where that is too much for a sentence.
bool say(const Operation& operation, const std::string& key, const Json& value, std::string& text) {
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
  std::string name = key;
  std::replace(name.begin(), name.end(), '_', ' ');
  const auto words = operation.words();
  if (value.is_string() && std::find(words.begin(), words.end(), value.get<std::string>()) != words.end()) {
    add(phrase(operation, value.get<std::string>()));
  } else if (value.is_boolean()) {
    add(value.get<bool>() ? name : "not " + name);
  } else if (value.is_primitive()) {
    add(name + " = " + (value.is_string() ? value.get<std::string>() : one_line(value)));
  } else if (is_tuple(value)) {
    add(name + " " + in_parentheses(value));
  } else if (value.is_array() && value.size() == 2 && is_tuple(value[0]) && is_tuple(value[1])) {
    add(name + " " + in_parentheses(value[0]) + (key == "overlap" ? " to " : ", ") + in_parentheses(value[1]));
  } else if (value.is_object()) {
    std::string inside;
    for (const auto& [part, inner] : value.items()) {
      if (!say(operation, part, inner, inside)) return false;
    }
    add(name + ": " + inside);
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::string phrase(const Operation& operation, const std::string& word) {
  const std::size_t slash = word.find('/');
  if (slash != std::string::npos)
    return phrase(operation, word.substr(0, slash)) + ", " + phrase(operation, word.substr(slash + 1));
  const std::vector<std::string> all = operation.words();
  for (const Phrase& entry : phrases) {
    const bool meant = entry.beside == nullptr || std::find(all.begin(), all.end(), entry.beside) != all.end();
    if (word == entry.word && meant) return entry.words;
  }
  std::string words = word;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string phrase(const Operation& operation, const Json& answer) {
  constexpr std::size_t longest = 200;
  if (answer.is_null()) return "no answer";
  if (answer.is_boolean()) return answer.get<bool>() ? "yes" : "no";
  std::string text;
  if (answer.is_object()) {
    for (const auto& [key, value] : answer.items()) {
      const std::string until_now = text;
      if (!say(operation, key, value, text) || text.size() > longest) {
        text = until_now;
        break;
      }
    }
  }
  return text;
}

std::string phrase(const Operation& operation, const Way& way) {
  const std::string answer = phrase(operation, way.answer);
  return way.truth == "value" ? answer : answer + " where it is " + phrase(operation, way.truth);
}

}  // namespace touchstone::report
