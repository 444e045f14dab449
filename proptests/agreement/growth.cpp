// SPDX-License-Identifier: Apache-2.0
#include <ctime>

#include "catalogue/operation/explained.h"
#include "proptests/each_operation.h"
#include "proptests/growing.h"

/// Whether time grows as each operation says (Metadata::time): that of a question, and of one sixteen times as long.
///
/// Nothing but time tells this of all of them, so it is measured: processor time of this thread, the best of some runs.
/// A ratio is refused beyond four times what is said: between n log n and n^2 lies a factor of twelve. What is faster
/// than it says is not noticed, which is the use of an upper bound.
namespace touchstone::proptests::growth_tests {
namespace {

using catalogue::Examination;
using catalogue::Growth;
using catalogue::Question;

bool asked_of_lists(const catalogue::Operation& operation) {
  return catalogue::elements_of_lists(operation.question_shape(), operation.zeros(1)) > 0;
}

double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The least of several runs, of 20 ms all together.
template <class Work>
double seconds_of(const Work& work) {
  double least = 0, all = 0;
  for (int runs = 0; runs < 1000 && all < 0.02; ++runs) {
    const double start = now();
    work();
    const double took = now() - start;
    least = runs == 0 ? took : std::min(least, took);
    all += took;
  }
  return least;
}

constexpr std::size_t times_longer = 16;
constexpr double most_of_what_is_said = 4;

/// Of such a length that the longer question takes a second or so.
std::size_t short_length(Growth growth) {
  switch (growth) {
    case Growth::constant:
    case Growth::linear:
    case Growth::linearithmic: return 1000;
    case Growth::quadratic:
    case Growth::quadratic_log: return 130;
    default: return 34;
  }
}

template <class Work>
void check_growth(const catalogue::Operation& operation, const char* what, Growth growth, const Work& work) {
  const std::size_t n = short_length(growth);
  const Question one = growing_question(operation, n), other = growing_question(operation, times_longer * n);
  const auto steps = [&](const Question& question) {
    return static_cast<double>(steps_of(growth, catalogue::elements_of_lists(operation.question_shape(), question)));
  };
  const double said = steps(other) / steps(one),
               ratio = seconds_of([&] { work(other); }) / seconds_of([&] { work(one); });
  INFO(operation.name() << ", " << what << ": " << name_of(growth) << " is " << said << " times as long, it took "
                        << ratio << " times");
  CHECK(ratio <= most_of_what_is_said * said);
}

}  // namespace

EACH_OPERATION("time grows as it says") {
  if (!asked_of_lists(operation)) {
    const catalogue::Time& time = operation.metadata().time;
    for (const Growth growth : {time.robust, time.oracle, time.ask, time.reference}) CHECK(growth == Growth::constant);
    return;
  }
  const catalogue::RowFunctions& row = operation.row();
  const catalogue::Time& time = operation.metadata().time;
  check_growth(operation, "robust", time.robust, [&](const Question& question) { row.robust(question, 0); });
  check_growth(operation, "oracle", time.oracle, [&](const Question& question) { row.solve(question); });
  check_growth(operation, "formula", time.reference, [&](const Question& question) { row.reference(question); });
  check_growth(operation, "ask", time.ask, [&](const Question& question) {
    const Examination examination(operation, question);
    catalogue::certificate_json(examination.certificate()), examination.judge_robust();
  });
}

}  // namespace touchstone::proptests::growth_tests
