// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>

#include "catalogue/operation/probes/explained.h"
#include "proptests/each_operation.h"
#include "proptests/mutation/growing.h"

/// Whether steps grow as each operation says (Metadata::time): those of a question, and of one eight times as long.
///
/// A step is a comparison of integers in robust, in the rows with their formulas or in the oracle: every loop has one.
/// Counts are the same on every machine. A ratio is refused beyond twice what is said: between n log n and n^2 lies
/// a factor of six. What is faster than it says is not noticed, which is the use of an upper bound.
namespace touchstone::proptests {

extern std::uint64_t steps_counted;  // counted_steps.cpp

namespace growth_tests {
namespace {

using catalogue::Examination;
using catalogue::Growth;
using catalogue::Question;

bool asked_of_lists(const catalogue::Operation& operation) {
  return catalogue::elements_of_lists(operation.question_shape(), operation.zeros(1)) > 0;
}

constexpr std::size_t times_longer = 8;
constexpr double most_of_what_is_said = 2;

/// Such that the longer question takes seconds at most.
std::size_t short_length(Growth growth) {
  switch (growth) {
    case Growth::constant:
    case Growth::linear: return 500;
    case Growth::linearithmic: return 4000;
    case Growth::quadratic:
    case Growth::quadratic_log: return 130;
    default: return 34;
  }
}

template <class Work>
void check_growth(const catalogue::Operation& operation, const char* what, Growth growth, const Work& work) {
  const std::size_t n = short_length(growth);
  const auto counted = [&](const Question& question) {
    steps_counted = 0;
    work(question);
    return static_cast<double>(steps_counted);
  };
  const auto declared = [&](const Question& question) {
    return static_cast<double>(steps_of(growth, catalogue::elements_of_lists(operation.question_shape(), question)));
  };
  const Question one = growing_question(operation, n), other = growing_question(operation, times_longer * n);
  const double said = declared(other) / declared(one), steps = counted(one), ratio = counted(other) / steps;
  INFO(operation.name() << ", " << what << ": " << name_of(growth) << " is " << said << " times as many steps as "
                        << steps << ", counted are " << ratio << " times as many");
  CHECK(steps > 0);
  CHECK(ratio <= most_of_what_is_said * said);
}

}  // namespace

EACH_OPERATION("steps grow as it says") {
  const catalogue::Time& time = operation.metadata().time;
  if (!asked_of_lists(operation)) {
    for (const Growth growth : {time.robust, time.oracle, time.ask, time.reference}) CHECK(growth == Growth::constant);
    return;
  }
  const catalogue::RowFunctions& row = operation.row();
  check_growth(operation, "robust", time.robust, [&](const Question& question) { row.robust(question, 0); });
  check_growth(operation, "oracle", time.oracle, [&](const Question& question) { row.solve(question); });
  check_growth(operation, "formula", time.reference, [&](const Question& question) { row.reference(question); });
  check_growth(operation, "ask", time.ask, [&](const Question& question) {
    const Examination examination(operation, question);
    catalogue::certificate_json(examination.certificate()), examination.judge_robust();
  });
}

}  // namespace growth_tests
}  // namespace touchstone::proptests
