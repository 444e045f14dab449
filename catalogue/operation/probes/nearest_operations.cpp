// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <map>

#include "catalogue/operation/operation.h"
#include "catalogue/operation/probes/synonyms.h"

namespace touchstone::catalogue {
namespace {

using WordList = std::vector<std::string>;

constexpr std::size_t longest_question = 80, shortest_word_of_a_question = 4;
constexpr int for_a_place = 3, for_a_word_of_a_phrase = 40, for_a_word_of_a_name = 24, for_a_word_of_a_question = 2;

bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// Lower-case singular words; "GJKDistance" is two words.
WordList words_of(std::string_view text) {
  WordList words(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool begins =
        is_upper(c) && i > 0 && (is_lower(text[i - 1]) || (i + 1 < text.size() && is_lower(text[i + 1])));
    const bool separates = std::isalnum(static_cast<unsigned char>(c)) == 0;
    if ((begins || separates) && !words.back().empty()) words.emplace_back();
    if (!separates) words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  if (words.back().empty()) words.pop_back();
  for (std::string& word : words)
    if (word.size() > 3 && word.ends_with('s') && !word.ends_with("ss")) word.pop_back();
  return words;
}

std::string joined(WordList::const_iterator from, WordList::const_iterator to) {
  std::string text;
  for (; from != to; ++from) text += *from;
  return text;
}

/// True if consecutive words spell the phrase, wherever either of them has spaces.
bool has_phrase(const WordList& words, const WordList& phrase) {
  const std::string spelt = joined(phrase.begin(), phrase.end());
  for (auto from = words.begin(); from != words.end(); ++from)
    for (auto to = from + 1;; ++to) {
      if (joined(from, to) == spelt) return true;
      if (to == words.end()) break;
    }
  return false;
}

bool has_word(const WordList& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::string why_not_computed(std::string_view name) {
  if (name.size() > longest_question) return "";
  const WordList words = words_of(name);
  for (const auto& [phrase, what] : not_computed())
    if (has_phrase(words, words_of(phrase))) return std::string("no operation computes ") + what;
  return "";
}

std::vector<std::string> nearest_operations(std::string_view name, std::size_t most) {
  if (name.size() > longest_question) return {};
  const WordList words = words_of(name);
  std::map<std::string, int> merits;
  for (const auto& [phrase, operations] : synonyms()) {
    const WordList of_phrase = words_of(phrase);
    if (!has_phrase(words, of_phrase)) continue;
    // The first operation of a phrase ranks before the second, by more than a word of its question.
    int merit = for_a_word_of_a_phrase * static_cast<int>(of_phrase.size());
    for (const char* operation : operations) merits[operation] += merit, merit -= for_a_place;
  }
  std::vector<std::pair<int, std::string>> ranked;
  for (const Operation* operation : all_operations()) {
    const WordList own = words_of(operation->name()), question = words_of(operation->metadata().question);
    int merit = merits[operation->name()];
    for (const std::string& word : words) {
      if (has_word(own, word)) merit += for_a_word_of_a_name;
      else if (word.size() >= shortest_word_of_a_question && has_word(question, word))
        merit += for_a_word_of_a_question;
    }
    if (merit > 0) ranked.emplace_back(merit, operation->name());
  }
  // Equally good ones keep the catalogue's order.
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> nearest;
  for (std::size_t i = 0; i < std::min(most, ranked.size()); ++i) nearest.push_back(ranked[i].second);
  return nearest;
}

}  // namespace touchstone::catalogue
