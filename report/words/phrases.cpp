// SPDX-License-Identifier: Apache-2.0
#include "report/words/phrases.h"

#include <algorithm>

#include "report/words/wording.h"

namespace touchstone::report {
namespace {

/// The wording of an enumerator. `beside`: only for types that also have that other enumerator.
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
    {"segment", "a common segment"},
    {"area", "a common area"},
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

constexpr std::size_t most_listed = 4;

std::string value_in_words(const Json& value) {
  std::string text = value.is_string() ? value.get<std::string>() : one_line(value);
  constexpr const char* about = "about ";
  return text.rfind(about, 0) == 0 ? "\u2248" + text.substr(6) : text;
}

/// "(1, 2)", or "(0, 5, 3, 4, ...)".
std::string in_parentheses(const Json& numbers) {
  constexpr std::size_t most = 6;
  std::string text = "(";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += i == 0 ? "" : ", ";
    if (i == most) return text + "\u2026)";
    text += value_in_words(numbers[i]);
  }
  return text + ")";
}

/// Numbers or indices.
bool is_tuple(const Json& value) {
  return value.is_array() && !value.empty() &&
         std::none_of(value.begin(), value.end(), [](const Json& part) { return part.is_structured(); });
}

/// "bodies" -> "body", "slabs" -> "slab".
std::string singular(const std::string& name) {
  const auto ends = [&](const std::string& end) {
    return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  return ends("ies") ? name.substr(0, name.size() - 3) + "y" : ends("s") ? name.substr(0, name.size() - 1) : name;
}

bool say(const Operation& operation, const std::string& key, const Json& value, std::string& text);

/// "ball 0 ends at (3, 4, 0) with velocity (0, 0, 0); ball 1 ..."
bool say_each(const Operation& operation, const std::string& name, const Json& list, std::string& text) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    text += text.empty() ? "" : "; ";
    if (i == most_listed) {
      text += "\u2026";
      break;
    }
    const Json& element = list[i];
    if (element.contains("position") && element.contains("velocity")) {
      text += "ball " + std::to_string(i) + " ends at " + in_parentheses(element["position"]) + " with velocity " +
              in_parentheses(element["velocity"]);
      continue;
    }
    std::string inside;
    for (const auto& [part, inner] : element.items())
      if (!say(operation, part, inner, inside)) return false;
    text += singular(name) + " " + std::to_string(i) + ": " + inside;
  }
  return true;
}

/// Adds the content of a field; returns false if that is too much for a sentence.
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
  } else if (value.is_array() && value.empty()) {
    add("no " + name);
  } else if (is_tuple(value)) {
    add(name + " " + in_parentheses(value));
  } else if (value.is_array() && std::all_of(value.begin(), value.end(), is_tuple)) {
    std::string list;
    for (std::size_t i = 0; i < value.size() && i <= most_listed; ++i) {
      list += list.empty() ? "" : key == "overlap" ? " to " : ", ";
      list += i == most_listed ? "\u2026" : in_parentheses(value[i]);
    }
    add(name + " " + list);
  } else if (value.is_array() && std::all_of(value.begin(), value.end(), [](const Json& e) { return e.is_object(); })) {
    return say_each(operation, name, value, text);
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
      if (!say(operation, key, value, text)) {
        text = until_now;
        break;
      }
      if (text.size() > longest) break;
    }
  }
  return text;
}

std::string phrase(const Operation& operation, const JudgedOutcome& outcome) {
  const std::string answer = phrase(operation, outcome.answer);
  const auto quoted = [](const std::string& words) { return "\u201c" + words + "\u201d"; };
  return outcome.truth == "value" ? answer
                                  : quoted(answer) + " where the truth is " + quoted(phrase(operation, outcome.truth));
}

std::string sentence(const Operation& operation, const Json& answer) {
  constexpr std::size_t longest = 240;
  const Json in_short = readable(answer, 12, 6);
  std::string text = phrase(operation, in_short);
  if (text.empty()) text = one_line(in_short);
  return text.size() > longest ? text.substr(0, text.rfind(',', longest)) + ", \u2026" : text;
}

}  // namespace touchstone::report
