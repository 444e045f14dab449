// SPDX-License-Identifier: Apache-2.0
#include "audit/judging/course.h"

#include <limits>
#include <utility>

namespace touchstone::audit {
namespace {

template <class Float>
Course course_of_formula(EncodedValue<Tracked<Float>> (*formula)(const Question&), const Question& question) {
  using Number = Tracked<Float>;
  Number::inconclusive() = Number::out_of_range() = false;
  Number::nearest_comparison() = std::numeric_limits<double>::infinity();
  EncodedValue<Number> answer = formula(question);
  return {std::move(answer.words), Number::nearest_comparison(), Number::inconclusive() || Number::out_of_range()};
}

}  // namespace

Course course_of(const RecordedCall& call) {
  const TrackedFormula& formula = call.operation->row().reference_tracked;
  return call.binary32 ? course_of_formula(formula.in_float, call.question)
                       : course_of_formula(formula.in_double, call.question);
}

}  // namespace touchstone::audit
