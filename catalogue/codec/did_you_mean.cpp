// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/did_you_mean.h"

#include <algorithm>

namespace touchstone::catalogue {
namespace {

constexpr std::size_t longest_name = 80, fewest_of_a_beginning = 3;

std::string folded(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') result += static_cast<char>(c - 'A' + 'a');
    else result += c == '-' ? '_' : c;
  }
  return result;
}

/// The least number of letters to replace, insert, delete, or swap with a neighbour; none is edited twice.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::vector<std::string> sorted_words(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (c == '_') words.emplace_back();
    else words.back() += c;
  }
  std::sort(words.begin(), words.end());
  return words;
}

template <class Names>
std::string nearest_of(std::string_view name, const Names& known) {
  if (name.empty() || name.size() > longest_name) return "";
  const std::string misspelt = folded(name);
  const std::vector<std::string> words = sorted_words(misspelt);
  std::size_t least = std::max<std::size_t>(1, misspelt.size() / 3) + 1;
  std::string nearest, longer;
  for (const auto& candidate : known) {
    const std::string spelt = folded(candidate);
    if (words == sorted_words(spelt)) return " (did you mean \"" + std::string(candidate) + "\"?)";
    if (longer.empty() && misspelt.size() >= fewest_of_a_beginning && spelt.starts_with(misspelt)) longer = candidate;
    const std::size_t off = distance(misspelt, spelt);
    // A word that shares no letter in place is a different name, however short.
    if (off < least && off < std::max(spelt.size(), misspelt.size())) least = off, nearest = candidate;
  }
  if (nearest.empty()) nearest = longer;
  return nearest.empty() ? "" : " (did you mean \"" + nearest + "\"?)";
}

}  // namespace

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
  return nearest_of(name, known);
}
std::string did_you_mean(std::string_view name, const std::vector<const char*>& known) {
  return nearest_of(name, known);
}

}  // namespace touchstone::catalogue
