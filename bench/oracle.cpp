// SPDX-License-Identifier: Apache-2.0
// The speed of the truth: for every operation of the catalogue the drawing of a question, the oracle's answer, the same
// with its certificate, and a full examination as in the audit's loop; the decisions alone; and exhaustive runs.

#include <string>

#include "bench/data_sets.h"
#include "bench/timing.h"
#include "catalogue/catalogue.h"
#include "catalogue/operation/operation.h"

namespace touchstone::bench {
namespace {

template <class Row>
const catalogue::Operation& operation_of() {
  static const catalogue::Operation& operation = *catalogue::find_operation(Row::metadata.name);
  return operation;
}

/// The cases of one set in the audit's form.
template <class Row>
const std::vector<catalogue::Question>& questions_of(DataSet set) {
  static DataSet made = set;
  static std::vector<catalogue::Question> questions;
  if (questions.empty() || made != set) {
    questions.clear();
    for (const auto& q : cases_of<Row>(made = set)) {
      questions.push_back({catalogue::packed(q)});
    }
  }
  return questions;
}

/// An audit's work on one question: both judgements and the outcome for the tally.
std::size_t examined(const catalogue::Operation& operation, const catalogue::Question& question) {
  const auto examination = operation.examine(question);
  return static_cast<std::size_t>(examination->judge_reference().verdict) +
         static_cast<std::size_t>(examination->judge_robust().verdict) + examination->outcome().size();
}

template <class Row>
void add_row(DataSet set) {
  using Q = typename Row::Question;
  const std::string group = std::string(Row::metadata.name) + "/" + name_of(set) + "/";
  const auto add = [&](const char* what, auto timed) { benchmark::RegisterBenchmark((group + what).c_str(), timed); };
  add("truth", [=](benchmark::State& s) {
    time_answers(s, cases_of<Row>(set), [](const Q& q) { return catalogue::ask_oracle<Row>(q); });
  });
  add("certificate", [=](benchmark::State& s) {
    time_answers(s, cases_of<Row>(set), [](const Q& q) { return catalogue::ask_oracle<Row>(q).certificate(); });
  });
  add("examination", [=](benchmark::State& s) {
    time_answers(s, questions_of<Row>(set),
                 [](const catalogue::Question& q) { return examined(operation_of<Row>(), q); });
  });
}

/// Questions of all families in turn, as the audit draws them.
template <class Row>
void draw_families(benchmark::State& state) {
  const catalogue::Operation& operation = operation_of<Row>();
  std::uint64_t index = 0;
  for (auto _ : state) {
    catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, Row::metadata.name, index));
    benchmark::DoNotOptimize(operation.draw(draws, index++ % operation.families().size()));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}

/// A part of the grid on which every number is one of 0 .. size - 1: robust against the oracle's integers, counted and
/// hashed.
void exhaust(benchmark::State& state, const catalogue::Operation& operation, int size) {
  const std::uint64_t configurations = operation.configurations(size).value_or(std::uint64_t{1} << 40);
  const std::uint64_t part = std::min(configurations, std::uint64_t{1} << 16);
  std::uint64_t first = 0, wrong = 0;
  for (auto _ : state) {
    if (first + part > configurations) first = 0;
    wrong += operation.count_decisions(size, first, first + part)->wrong;
    first += part;
  }
  if (wrong != 0) state.SkipWithError("robust and the oracle differ");
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(part));
}

void add_exhaustive(const catalogue::Operation& operation) {
  if (!operation.count_decisions(2, 0, 1)) return;
  for (const int size : {3, 4, 10}) {
    if (operation.name() == "triangle_triangle" && size > 6) continue;  // exhaustive runs refuse larger grids
    const std::string name = operation.name() + "/grid_" + std::to_string(size) + "/exhaust";
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&operation, size](benchmark::State& s) { exhaust(s, operation, size); });
  }
}

/// Adds the decisions that the oracle can also make alone.
void add_decisions(DataSet set) {
  using catalogue::rows::orientation, catalogue::rows::segment_segment;
  const auto add = [&](const char* op, auto timed) {
    benchmark::RegisterBenchmark((std::string(op) + "/" + name_of(set) + "/decision").c_str(), timed);
  };
  add("segment_segment", [=](benchmark::State& s) {
    time_decisions(s, cases_of<segment_segment>(set), [](const segment_segment::Question& q) {
      return static_cast<int>(oracle::segment_segment_relation(std::get<0>(q), std::get<1>(q)));
    });
  });
  add("orientation", [=](benchmark::State& s) {
    time_decisions(s, cases_of<orientation>(set), [](const orientation::Question& q) {
      return static_cast<int>(oracle::orientation_side(std::get<0>(q), std::get<1>(q), std::get<2>(q)));
    });
  });
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone;
  catalogue::for_each_row([]<class Row>() {
    for (const bench::DataSet set : bench::data_sets) bench::add_row<Row>(set);
    const std::string name = std::string(Row::metadata.name) + "/all_families/draw";
    benchmark::RegisterBenchmark(name.c_str(), bench::draw_families<Row>);
  });
  for (const bench::DataSet set : bench::data_sets) bench::add_decisions(set);
  for (const catalogue::Operation* operation : catalogue::all_operations()) bench::add_exhaustive(*operation);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
