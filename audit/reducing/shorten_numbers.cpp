// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "audit/reducing/passes.h"
#include "audit/reducing/question_parts.h"
#include "catalogue/codec/nearest_double.h"

namespace touchstone::audit::reducing {
namespace {

constexpr int most_digits = 16, most_bits = 52;
constexpr std::size_t most_others = 32;  // other numbers of a question that a number is set to

double to_digits(double number, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", digits - 1, number);
  return *nearest_double(text);
}

double to_bits(double number, int bits) {
  int exponent = 0;
  const double mantissa = std::frexp(number, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, bits)), exponent - bits);
}

bool shorter_number(double a, double b) { return briefer({{a}, {}}, {{b}, {}}); }

/// The candidates for a number, the shortest first.
std::vector<double> shorter_than(double number, const std::vector<double>& others) {
  std::vector<double> values{std::fabs(number)};
  for (int digit = -9; digit <= 9; ++digit) values.push_back(digit);
  if (std::isfinite(number)) {
    for (const double whole : {std::nearbyint(number), std::trunc(number), std::trunc(number / 2)})
      values.push_back(whole);
    for (int digits = 1; digits <= most_digits; ++digits) values.push_back(to_digits(number, digits));
    for (int bits = 1; bits <= most_bits; ++bits) values.push_back(to_bits(number, bits));
    // From an extreme magnitude it would take a thousand rounds to come down by halves.
    int exponent = 0;
    const double mantissa = std::frexp(number, &exponent);
    for (const int share : {2, 4, 8, 16, 32}) values.push_back(std::ldexp(mantissa, exponent - exponent / share));
  }
  values.insert(values.end(), others.begin(), others.end());
  for (double& value : values) value += 0.0;  // no negative zero
  std::erase_if(values, [&](double value) { return !std::isfinite(value) || !shorter_number(value, number); });
  std::sort(values.begin(), values.end(), shorter_number);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Every number at first <= i < last rounded by one of these methods, the coarsest first.
constexpr int roundings = 20;
std::optional<Question> rounded(const Question& question, std::size_t first, std::size_t last, int rounding) {
  Question result = question;
  for (std::size_t i = first; i < last; ++i) {
    double& number = result.numbers[i];
    if (!std::isfinite(number)) continue;
    number = rounding == 0   ? 0
             : rounding == 1 ? std::nearbyint(number)
             : rounding < 12 ? to_digits(number, rounding - 1)
                             : to_bits(number, 3 * (rounding - 11));
    number += 0.0;
  }
  return result;
}

/// All numbers together, then halves of them, quarters ... pairs.
bool shorten_together(Search& search) {
  bool better = false;
  const std::size_t count = search.best().numbers.size();
  for (std::size_t run = count; run > 1 && !search.over(); run = (run + 1) / 2) {
    for (std::size_t at = 0; at < count; at += run) {
      const auto candidate = [&](std::size_t rounding) {
        return rounded(search.best(), at, std::min(at + run, count), static_cast<int>(rounding));
      };
      better = search.first(roundings, candidate).has_value() || better;
    }
    if (run == 2) break;
  }
  return better;
}

/// Numbers that occur more than once, at all their occurrences.
bool shorten_equal_ones(Search& search) {
  bool better = false;
  std::map<double, std::size_t> occurrences;
  for (const double number : search.best().numbers) ++occurrences[number];
  std::erase_if(occurrences, [](const auto& entry) { return entry.second < 2 || entry.first == 0; });
  for (const auto& [number, occurs] : occurrences) {
    const std::vector<double> values = shorter_than(number, {});
    const auto candidate = [&, old = number](std::size_t i) -> std::optional<Question> {
      Question question = search.best();
      std::replace(question.numbers.begin(), question.numbers.end(), old, values[i]);
      return question;
    };
    better = search.first(values.size(), candidate).has_value() || better;
  }
  return better;
}

bool shorten_each(Search& search) {
  bool better = false;
  for (std::size_t place = 0; place < search.best().numbers.size() && !search.over(); ++place) {
    std::vector<double> others = search.best().numbers;
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    if (others.size() > most_others) others.clear();
    const std::vector<double> values = shorter_than(search.best().numbers[place], others);
    const auto candidate = [&](std::size_t i) -> std::optional<Question> {
      Question question = search.best();
      question.numbers[place] = values[i];
      return question;
    };
    better = search.first(values.size(), candidate).has_value() || better;
  }
  return better;
}

bool lessen_words(Search& search) {
  bool better = false;
  const QuestionParts parts = parts_of(*search.operation().row().question, search.best());
  for (const WordPlace& place : parts.words) {
    if (place.shape->kind == Shape::Kind::optional || place.shape->kind == Shape::Kind::choice) continue;
    const auto candidate = [&](std::size_t word) -> std::optional<Question> {
      Question question = search.best();
      question.words[place.word] = static_cast<Word>(word);
      return question;
    };
    better =
        search.first(std::min<Word>(search.best().words[place.word], most_others), candidate).has_value() || better;
  }
  return better;
}

}  // namespace

bool shorten_numbers(Search& search) {
  bool better = lessen_words(search);
  better = shorten_together(search) || better;
  better = shorten_equal_ones(search) || better;
  return shorten_each(search) || better;
}

}  // namespace touchstone::audit::reducing
