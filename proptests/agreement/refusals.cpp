// SPDX-License-Identifier: Apache-2.0
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "catalogue/operation/probes/not_finite.h"
#include "oracle/certificates/check.h"
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
  } else if (value.is_object()) {
    for (const auto& [key, part] : value.items()) {
      if (found.empty()) found = path_of_mark(part, path.empty() ? key : path + "." + key, mark);
    }
  }
  return found;
}

template <class Ask>
std::string refusal(const Ask& ask) {
  try {
    ask();
    return "";
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
}

/// The path of number i of a question.
std::string path_of_number(const Operation& operation, Question question, std::size_t i) {
  std::fill(question.numbers.begin(), question.numbers.end(), 0);
  question.numbers[i] = 12345;
  return path_of_mark(operation.print(question), "", 12345);
}

/// Who refuses a question with another field or rule than `expected`, in one environment: the oracle, the reader of
/// `ask`, or the checker of certificates; robust in all.
std::string refused_otherwise(const std::string& expected, const Operation& operation, const Question& question) {
  const catalogue::Json printed = operation.print(question);
  const std::string by_oracle = refusal([&] { operation.examine(question); });
  if (by_oracle != expected) return "the oracle says " + by_oracle;
  const std::string by_reader = refusal([&] { operation.parse(catalogue::parse_line(catalogue::one_line(printed))); });
  if (by_reader != expected) return "the reader says " + by_reader;
  const std::size_t colon = expected.find(": ");
  const catalogue::Json refused{{"field", expected.substr(0, colon)}, {"rule", expected.substr(colon + 2)}};
  const catalogue::Json line{{"op", operation.name()}, {"input", printed}, {"refused", refused}};
  if (const auto checked = certify::refuse_text(catalogue::one_line(line))) return "certify says " + *checked;
  for (std::size_t environment = 0; environment < environment_count; ++environment) {
    const std::string by_robust = robust_bits(operation, question, environment).refused;
    if (by_robust != expected) return "robust says " + by_robust + " (" + environment_name(environment) + ")";
  }
  return "";
}

/// The same where number i of a question is not finite.
std::string unlike(const std::string& expected, const Operation& operation, const Question& question, std::size_t i) {
  for (const double bad : {infinity, -infinity, not_a_number, -not_a_number}) {
    const Question asked = catalogue::with_not_finite(operation, question, i, bad);
    const std::string complaint = refused_otherwise(expected, operation, asked);
    if (!complaint.empty()) return complaint;
  }
  return "";
}

}  // namespace

EACH_OPERATION("a number that is not finite is refused by its field, wherever it stands, in every environment") {
  for (const Question& zeros : operation.zeros_of_alternatives()) {
    for (std::size_t i = 0; i < zeros.numbers.size(); ++i) {
      const std::string path = path_of_number(operation, zeros, i);
      REQUIRE(!path.empty());
      demand(operation.name() + ", " + path + ": refused",
             [&] { return unlike(path + ": finite number", operation, zeros, i); });
    }
  }
}

EACH_OPERATION("the first number that is not finite is named before any other rule; then robust and oracle agree") {
  property(
      operation.name() + ": refusals are equal",
      [&] {
        DrawStream draws = DrawStream::seeded(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
        Question question = operation.draw(draws, draws.below(operation.families().size()));
        for (double& number : question.numbers) {
          switch (draws.below(8)) {
            case 4: number = 0; break;
            case 5: number = -number; break;
            case 6: number = infinity; break;
            case 7: number = not_a_number; break;
            default: break;
          }
        }
        const auto bad = std::find_if_not(question.numbers.begin(), question.numbers.end(),
                                          [](double number) { return std::isfinite(number); });
        const std::string mismatch = operation.refusal_mismatch(question);
        if (!mismatch.empty()) RC_FAIL(mismatch + " " + catalogue::one_line(operation.print(question)));
        for (std::size_t environment = 1; environment < environment_count; ++environment) {
          RC_ASSERT(robust_bits(operation, question, environment) == robust_bits(operation, question, 0));
        }
        if (bad == question.numbers.end() || draws.below(16) != 0) return;
        const auto first = static_cast<std::size_t>(bad - question.numbers.begin());
        const std::string complaint =
            refused_otherwise(path_of_number(operation, question, first) + ": finite number", operation, question);
        if (!complaint.empty()) RC_FAIL(complaint + " " + catalogue::one_line(operation.print(question)));
      },
      2000);
}

}  // namespace touchstone::proptests::refusals_tests
