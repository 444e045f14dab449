// SPDX-License-Identifier: Apache-2.0
#include <rapidcheck.h>

#include <limits>

#include "catalogue/operation/not_finite.h"
#include "proptests/any_robust_bits.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"

namespace touchstone::proptests::refusals_tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The path of the number at a place of the question, found by printing a question that has only that number:
/// "a[0][1]".
std::string path_of_mark(const catalogue::Json& value, const std::string& path, double mark) {
  if (value.is_number()) return value.get<double>() == mark ? path : "";
  std::string found;
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size() && found.empty(); ++i) {
      found = path_of_mark(value[i], path + "[" + std::to_string(i) + "]", mark);
    }
  } else {
    for (const auto& [key, part] : value.items()) {
      if (found.empty()) found = path_of_mark(part, path.empty() ? key : path + "." + key, mark);
    }
  }
  return found;
}

std::string refusal_by_oracle(const Operation& operation, const Question& question) {
  try {
    operation.examine(question);
    return "";
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
}

/// How oracle and robust answer otherwise than with `expected` where number i of a question is not finite.
std::string unlike(const std::string& expected, const Operation& operation, const Question& question, std::size_t i) {
  for (const double bad : {infinity, -infinity, not_a_number, -not_a_number}) {
    const Question asked = catalogue::with_not_finite(operation, question, i, bad);
    const std::string said = refusal_by_oracle(operation, asked);
    if (said != expected) return "the oracle says " + said;
    for (std::size_t environment = 0; environment < environment_count; ++environment) {
      const std::string answered = robust_bits(operation, asked, environment).refused;
      if (answered != expected) return "robust says " + answered + " (" + environment_name(environment) + ")";
    }
  }
  return "";
}

}  // namespace

EACH_OPERATION("a number that is not finite is refused by its field, wherever it stands, in every environment") {
  for (const Question& zeros : operation.zeros_of_alternatives()) {
    for (std::size_t i = 0; i < zeros.numbers.size(); ++i) {
      Question marked = zeros;
      marked.numbers[i] = 12345;
      const std::string path = path_of_mark(operation.print(marked), "", 12345);
      REQUIRE(!path.empty());
      demand(operation.name() + ", " + path + ": refused",
             [&] { return unlike(path + ": finite number", operation, zeros, i); });
    }
  }
}

EACH_OPERATION("of several numbers that are not finite the first is named, and before it any rule broken earlier") {
  property(
      operation.name() + ": refusals are equal",
      [&] {
        Choices choices = Choices::seeded(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
        Question question = operation.draw(choices, choices.below(operation.families().size()));
        for (double& number : question.numbers) {
          switch (choices.below(8)) {
            case 4: number = 0; break;
            case 5: number = -number; break;
            case 6: number = infinity; break;
            case 7: number = not_a_number; break;
            default: break;
          }
        }
        const std::string mismatch = operation.refusal_mismatch(question);
        if (!mismatch.empty()) RC_FAIL(mismatch + " " + catalogue::one_line(operation.print(question)));
        for (std::size_t environment = 1; environment < environment_count; ++environment) {
          RC_ASSERT(robust_bits(operation, question, environment) == robust_bits(operation, question, 0));
        }
      },
      2000);
}

}  // namespace touchstone::proptests::refusals_tests
