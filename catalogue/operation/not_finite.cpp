// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/not_finite.h"

namespace touchstone::catalogue {
namespace {

bool refused_as_not_finite(const Operation& operation, const Question& question) {
  try {
    operation.row().solve(question);
  } catch (const InvalidInput& refused) {
    return refused.rule() == "finite number";
  }
  return false;
}

}  // namespace

Question with_not_finite(const Operation& operation, const Question& zeros, std::size_t place, double bad) {
  Question small = zeros;
  const std::vector<std::size_t> places = places_of_numbers(operation.question_shape(), zeros);
  for (std::size_t i = 0; i < places.size(); ++i) small.numbers[i] = static_cast<double>(1 + places[i] % 3);
  Question repaired = small;
  if (operation.row().repair != nullptr) operation.row().repair(repaired);
  const auto spoilt = [&](Question question) {
    question.numbers.at(place) = bad;
    return question;
  };
  for (const Question& base : {small, repaired, operation.map_centre()}) {
    if (place < base.numbers.size() && refused_as_not_finite(operation, spoilt(base))) return spoilt(base);
  }
  return spoilt(small);
}

}  // namespace touchstone::catalogue
