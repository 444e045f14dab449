// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/sensitivity.h"

#include <cmath>

#include "catalogue/numbers/ulps.h"

namespace touchstone::catalogue {
namespace {

std::vector<double> nearest_of(const EncodedTruth& truth) {
  std::vector<double> numbers;
  for (const TrueNumber& number : truth.numbers) numbers.push_back(nearest(number));
  return numbers;
}

/// Moved a little further from 0, or, if the oracle refuses that, a little nearer. Empty if it refuses both.
std::vector<double> with_one_moved(const Operation& operation, const Question& question, std::size_t i, double& by) {
  const double number = question.numbers[i];
  for (const double factor : {1 + 0x1p-32, 1 - 0x1p-32}) {
    Question moved = question;
    const double scaled = number * factor, beyond = std::nextafter(number, factor > 1 ? number * HUGE_VAL : 0.0);
    moved.numbers[i] = scaled == number ? beyond : scaled;
    by = std::fabs((moved.numbers[i] - number) / number);
    if (!std::isfinite(moved.numbers[i])) continue;
    try {
      return nearest_of(operation.row().solve(moved).answer);
    } catch (const InvalidInput&) {
    }
  }
  return {};
}

}  // namespace

std::vector<Sensitivity> sensitivities(const Operation& operation, const Question& question) {
  const EncodedTruth truth = operation.row().solve(question).answer;
  const EncodedValue<double> formula = operation.row().reference(question);
  if (!truth.words.empty() || formula.numbers.size() != truth.numbers.size()) return {};
  const std::vector<double> numbers = nearest_of(truth);
  std::vector<double> conditions(numbers.size(), 0);
  for (std::size_t i = 0; i < question.numbers.size(); ++i) {
    double by = 0;
    if (question.numbers[i] == 0) continue;
    const std::vector<double> moved = with_one_moved(operation, question, i, by);
    if (moved.size() != numbers.size()) continue;
    for (std::size_t k = 0; k < numbers.size(); ++k)
      conditions[k] += std::fabs((moved[k] - numbers[k]) / numbers[k]) / by;
  }
  std::vector<Sensitivity> found;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (std::isfinite(conditions[k]) && conditions[k] > 0)
      found.push_back({conditions[k], distance_in_ulps(formula.numbers[k], truth.numbers[k])});
  }
  return found;
}

}  // namespace touchstone::catalogue
