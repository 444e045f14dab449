// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/families.h"

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>

#include "catalogue/families/numbers.h"

namespace touchstone::catalogue {
namespace {

using Draw = std::function<double(DrawStream&)>;

/// Integers of one size, which is drawn first: up to the limit at which they, their differences or their products just
/// fit into 32 or 64 bits, signed or not, or into a double.
Draw integers_at_a_seam(DrawStream& draws) {
  static constexpr int seams[]{16, 31, 32, 53};
  const int seam = seams[draws.below(4)], bits = seam - static_cast<int>(draws.below(2));
  return [bits](DrawStream& c) {
    const double most = std::ldexp(1, bits), beside = small_integer(c, 2);
    const double size = c.below(4) == 3 ? most + beside : static_cast<double>(c.below(std::uint64_t{1} << bits));
    return c.below(2) == 1 ? -size : size;
  };
}

/// A family that follows from the types alone: its method of drawing a number is chosen once for each question.
struct Derived {
  const char* name;
  Draw (*numbers)(DrawStream&);
  bool scaled = false;
};
const Derived derived_families[] = {
    {"grid", [](DrawStream&) -> Draw { return [](DrawStream& c) { return static_cast<double>(c.below(4)); }; }, true},
    {"typed", [](DrawStream&) -> Draw { return typed; }},
    {"random", [](DrawStream&) -> Draw { return ordinary; }},
    {"binary32",
     [](DrawStream&) -> Draw {
       return [](DrawStream& c) { return static_cast<double>(static_cast<float>(ordinary(c))); };
     }},
    {"mixed_exponents", [](DrawStream&) -> Draw { return mixed_exponent; }},
    {"any_bits", [](DrawStream&) -> Draw { return any_finite; }},
    {"integers_at_a_seam", integers_at_a_seam},
};

/// Most indices name an element of a list of usual length.
constexpr std::uint64_t most_indices = 8;

void append_drawn(const Shape& shape, DrawStream& draws, const Draw& number, Question& question) {
  const auto word = [&](std::uint64_t values) {
    question.words.push_back(static_cast<Word>(draws.below(values)));
    return question.words.back();
  };
  switch (shape.kind) {
    case Shape::Kind::number: question.numbers.push_back(number(draws)); return;
    case Shape::Kind::word: word(shape.words.size()); return;
    case Shape::Kind::flag: word(2); return;
    case Shape::Kind::index: word(most_indices); return;
    case Shape::Kind::optional:
      if (word(2) != 0) append_drawn(*shape.parts[0].shape, draws, number, question);
      return;
    case Shape::Kind::list: {
      const std::size_t length = list_length(draws);
      question.words.push_back(static_cast<Word>(length));
      for (std::size_t i = 0; i < length; ++i) append_drawn(*shape.parts[0].shape, draws, number, question);
      return;
    }
    case Shape::Kind::choice: {
      const Word which = word(shape.parts.size());
      return append_drawn(*shape.parts[which].shape, draws, number, question);
    }
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) {
        if (part.drawn) append_drawn(*part.shape, draws, number, question);
        else question.words.push_back(0);
      }
  }
}

void scale(const RowFunctions& row, Question& question, int exponent) {
  if (exponent == 0) return;
  if (row.scale != nullptr) return row.scale(question, exponent);
  for (double& number : question.numbers) number = std::ldexp(number, exponent);
}

/// A number that exceeded the range, here or in the row, becomes the greatest double.
void keep_finite(Question& question) {
  for (double& number : question.numbers) {
    if (!std::isfinite(number)) number = std::copysign(std::numeric_limits<double>::max(), number);
  }
}

void nudge(Question& question, DrawStream& draws) {
  const std::size_t which = draws.below(question.numbers.size());
  const int sign = draws.below(2) == 1 ? -1 : 1, ulps = sign * (1 + static_cast<int>(draws.below(3)));
  question.numbers[which] = moved_by_ulps(question.numbers[which], ulps);
}

Question drawn(const RowFunctions& row, DrawStream& draws, const Derived& family) {
  Question question;
  append_drawn(*row.question, draws, family.numbers(draws), question);
  if (row.repair != nullptr) row.repair(question);
  if (family.scaled) scale(row, question, scale_exponent(draws));
  keep_finite(question);
  return question;
}

}  // namespace

Families::Families(const RowFunctions& row) : row_(row) {
  for (const auto& hard : row.hard_cases) names_.push_back(hard.name);
  for (std::size_t which = 0; which < row.hard_cases.size(); ++which) {
    if (row.hard_cases[which].unscaled) continue;
    moved_.push_back(which);
    names_.push_back(row.hard_cases[which].name + "+ulp");
  }
  for (const Derived& derived : derived_families) names_.emplace_back(derived.name);
  const std::set<std::string> different(names_.begin(), names_.end());
  if (different.size() != names_.size()) throw std::logic_error("two families of an operation have one name");
}

Question Families::draw(DrawStream& draws, std::size_t family) const {
  const std::size_t hard = row_.hard_cases.size();
  if (family >= hard + moved_.size()) return drawn(row_, draws, derived_families[family - hard - moved_.size()]);
  const std::size_t which = family < hard ? family : moved_[family - hard];
  Question question = row_.draw_hard_case(which, draws);
  if (row_.hard_cases[which].unscaled) return question;
  scale(row_, question, scale_exponent(draws));
  keep_finite(question);
  if (family >= hard && !question.numbers.empty()) nudge(question, draws);
  return question;
}

}  // namespace touchstone::catalogue
