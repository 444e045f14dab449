// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "catalogue/row.h"
#include "catalogue/codec/flat.h"

/// The families of inputs of an operation: its hard cases, each also moved by an ulp, and what follows from its types.
namespace touchstone::audit {

template <class Row>
class Families {
 public:
  using Question = typename Row::Question;

  Families() : hard_(Row::hard_cases()) {
    for (const HardCase<Question>& hard : hard_) names_.push_back(hard.name);
    for (const HardCase<Question>& hard : hard_) names_.push_back(hard.name + "+ulp");
    for (const Derived& derived : derived_families) names_.push_back(derived.name);
  }

  const std::vector<std::string>& names() const { return names_; }

  Question draw(Choices& choices, std::size_t family) const {
    if (family >= 2 * hard_.size()) return draw_derived(choices, derived_families[family - 2 * hard_.size()]);
    Question question = hard_[family % hard_.size()].draw(choices);
    scale(question, scale_exponent(choices));
    keep_finite(question);
    if (family >= hard_.size()) nudge(question, choices);
    return question;
  }

 private:
  struct Derived {
    const char* name;
    double (*number)(Choices&);
    bool scaled;
  };
  static constexpr Derived derived_families[] = {
      {"grid", [](Choices& c) { return static_cast<double>(c.below(4)); }, true},
      {"typed", typed, false},
      {"random", ordinary, false},
      {"binary32", [](Choices& c) { return static_cast<double>(static_cast<float>(ordinary(c))); }, false},
      {"mixed_exponents", mixed_exponent, false},
      {"any_bits", any_finite, false},
  };

  static Question draw_derived(Choices& choices, const Derived& derived) {
    Question question{};
    walk(
        question, [&](double& number) { number = derived.number(choices); },
        [&](auto& list) { list.resize(list_length(choices)); });
    if constexpr (requires { Row::repair(question); }) Row::repair(question);
    if (derived.scaled) scale(question, scale_exponent(choices));
    keep_finite(question);
    return question;
  }

  static void scale(Question& question, int exponent) {
    if (exponent == 0) return;
    if constexpr (requires { Row::scale(question, exponent); }) {
      Row::scale(question, exponent);
    } else {
      for_each_number(question, [&](double& number) { number = std::ldexp(number, exponent); });
    }
  }

  /// What grew beyond the range, here or in the row, is the greatest double.
  static void keep_finite(Question& question) {
    for_each_number(question, [&](double& number) {
      if (!std::isfinite(number)) number = std::copysign(std::numeric_limits<double>::max(), number);
    });
  }

  static void nudge(Question& question, Choices& choices) {
    std::size_t numbers = 0;
    for_each_number(question, [&](double&) { ++numbers; });
    const std::size_t which = choices.below(numbers);
    const int sign = choices.below(2) == 1 ? -1 : 1, ulps = sign * (1 + static_cast<int>(choices.below(3)));
    std::size_t i = 0;
    for_each_number(question, [&](double& number) {
      if (i++ == which) number = moved_by_ulps(number, ulps);
    });
  }

  std::vector<HardCase<Question>> hard_;
  std::vector<std::string> names_;
};

}  // namespace touchstone::audit
