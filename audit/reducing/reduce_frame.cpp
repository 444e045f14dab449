// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "audit/reducing/passes.h"
#include "audit/reducing/question_parts.h"

namespace touchstone::audit::reducing {
namespace {

constexpr std::size_t most_places = 16;     // that are tried as origins
constexpr std::size_t most_to_order = 64;   // elements of a list
constexpr std::size_t most_numbers = 4096;  // of a question that is scaled
constexpr int most_scales = 64;

using Offset = std::array<double, 3>;

/// The first points of a question, complete and along a single axis.
std::vector<Offset> offsets_of(const Question& question, const QuestionParts& parts) {
  std::vector<Offset> whole;
  std::array<std::set<double>, 3> along;
  for (std::size_t i = 0; i < parts.numbers.size() && whole.size() < most_places; ++i) {
    const NumberPlace& place = parts.numbers[i];
    if (place.meaning != Meaning::place || place.axis > 2) continue;
    if (place.axis == 0 || whole.empty()) whole.push_back({});
    whole.back()[place.axis] = question.numbers[i];
    along[place.axis].insert(question.numbers[i]);
  }
  for (std::size_t axis = 0; axis < along.size(); ++axis) {
    for (const double number : along[axis]) {
      Offset offset{};
      offset[axis] = number;
      whole.push_back(offset);
    }
  }
  return whole;
}

bool move_to_origin(Search& search) {
  const Shape& shape = *search.operation().row().question;
  bool better = false;
  for (bool moved = true; moved && !search.over(); better = better || moved) {
    const QuestionParts parts = parts_of(shape, search.best());
    const std::vector<Offset> offsets = offsets_of(search.best(), parts);
    const auto at_origin = [&](std::size_t at) -> std::optional<Question> {
      Question question = search.best();
      for (std::size_t i = 0; i < parts.numbers.size(); ++i) {
        const NumberPlace& place = parts.numbers[i];
        if (place.meaning == Meaning::place && place.axis <= 2) question.numbers[i] -= offsets[at][place.axis];
      }
      return question;
    };
    moved = search.first(offsets.size(), at_origin).has_value();
  }
  return better;
}

/// Multiplies every length by 2^exponent.
Question scaled(const Operation& operation, const Question& question, const QuestionParts& parts, int exponent) {
  Question result = question;
  if (operation.row().scale != nullptr) {
    operation.row().scale(result, exponent);
    return result;
  }
  for (std::size_t i = 0; i < result.numbers.size(); ++i)
    if (parts.numbers[i].meaning != Meaning::number) result.numbers[i] = std::ldexp(result.numbers[i], exponent);
  return result;
}

/// The exponents of two that bring the greatest number to about 1, ... those that make every number an integer.
std::vector<int> exponents_of_scales(const Question& question) {
  int greatest = -2000, last_bit = 2000;
  for (const double number : question.numbers) {
    if (number == 0 || !std::isfinite(number)) continue;
    int exponent = 0;
    double mantissa = std::frexp(number, &exponent);
    greatest = std::max(greatest, exponent);
    int bits = 0;
    for (; mantissa != std::trunc(mantissa); mantissa *= 2) ++bits;
    last_bit = std::min(last_bit, exponent - bits);
  }
  std::vector<int> exponents;
  const int first = -greatest;
  for (int exponent = first; exponent <= std::min(-last_bit, first + most_scales); ++exponent)
    if (exponent != 0) exponents.push_back(exponent);
  return exponents;
}

/// Multiplies every coordinate along an axis by 2^exponent.
Question scaled_along(const Question& question, const QuestionParts& parts, std::size_t axis, int exponent) {
  Question result = question;
  for (std::size_t i = 0; i < result.numbers.size(); ++i) {
    const NumberPlace& place = parts.numbers[i];
    const bool coordinate = place.meaning == Meaning::place || place.meaning == Meaning::direction;
    if (coordinate && place.axis == axis) result.numbers[i] = std::ldexp(result.numbers[i], exponent);
  }
  return result;
}

/// Scales all lengths, or the coordinates along a single axis.
bool scale_to_one(Search& search, std::optional<std::size_t> axis) {
  const QuestionParts parts = parts_of(*search.operation().row().question, search.best());
  if (parts.numbers.size() > most_numbers) return false;
  Question measured = search.best();
  for (std::size_t i = 0; axis && i < measured.numbers.size(); ++i)
    if (parts.numbers[i].axis != *axis) measured.numbers[i] = 0;
  std::vector<Question> candidates;
  for (const int exponent : exponents_of_scales(measured))
    candidates.push_back(axis ? scaled_along(search.best(), parts, *axis, exponent)
                              : scaled(search.operation(), search.best(), parts, exponent));
  std::sort(candidates.begin(), candidates.end(),
            [&](const Question& a, const Question& b) { return shorter(search.operation(), a, b); });
  return search.first(candidates.size(), [&](std::size_t i) { return candidates[i]; }).has_value();
}

/// The elements of a list in another order: `order` lists their indices.
Question in_order(const Question& question, const ListPlace& list, const std::vector<std::size_t>& order) {
  Question elements;
  for (const std::size_t i : order) {
    const Position &from = list.begin[i], &to = list.begin[i + 1];
    const double* const numbers = question.numbers.data();
    const Word* const words = question.words.data();
    elements.numbers.insert(elements.numbers.end(), numbers + from.number, numbers + to.number);
    elements.words.insert(elements.words.end(), words + from.word, words + to.word);
  }
  return with_part(question, {list.begin.front(), list.begin.back()}, elements);
}

bool order_list(Search& search, std::size_t number) {
  const QuestionParts parts = parts_of(*search.operation().row().question, search.best());
  const ListPlace& list = parts.lists[number];
  const std::size_t length = list.size();
  if (length < 2 || length > most_to_order) return false;
  // Tries the sorted order, then rotations to each element, forwards and backwards.
  const auto ordered = [&](std::size_t at) -> std::optional<Question> {
    std::vector<std::size_t> order(length);
    for (std::size_t i = 0; i < length; ++i)
      order[i] = at < length ? (i + at) % length : (2 * length + at - i) % length;
    if (at == 0) {
      const auto number_of = [&](std::size_t i, std::size_t k) {
        return search.best().numbers[list.begin[i].number + k];
      };
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const std::size_t n =
            std::min(list.begin[a + 1].number - list.begin[a].number, list.begin[b + 1].number - list.begin[b].number);
        for (std::size_t k = 0; k < n; ++k)
          if (number_of(a, k) != number_of(b, k)) return number_of(a, k) < number_of(b, k);
        return a < b;
      });
    }
    return in_order(search.best(), list, order);
  };
  return search.first(2 * length, ordered).has_value();
}

}  // namespace

bool reduce_frame(Search& search) {
  bool better = move_to_origin(search);
  better = scale_to_one(search, std::nullopt) || better;
  for (const std::size_t axis : {0, 1, 2}) better = scale_to_one(search, axis) || better;
  const Shape& shape = *search.operation().row().question;
  for (std::size_t list = 0; list < parts_of(shape, search.best()).lists.size() && !search.over(); ++list) {
    while (order_list(search, list)) better = true;
  }
  return better;
}

}  // namespace touchstone::audit::reducing
