// SPDX-License-Identifier: Apache-2.0
// Decisions over arrays: every operation of the catalogue that has them, beside the naive formula over the same columns
// (one row at a time, and in the lanes of the same instruction sets), robust and CGAL's Epick one question at a time.
// And from memory, where the cache is too small, beside the rate at which the same memory can be read.
//
// bench/arrays --verify compares all array answers with robust, one question at a time, and times nothing.

#include <algorithm>
#include <cstring>
#include <string>

#include "bench/cgal_peers.h"
#include "bench/data_sets.h"
#include "bench/isa/naive_loops.h"
#include "bench/peers_of_rays.h"
#include "bench/timing.h"

namespace touchstone::bench {
namespace {

using catalogue::Operation;
using catalogue::Question;
using catalogue::Word;
using robust::batch::Column;
using robust::batch::Instructions;
using robust::batch::isa::NaiveLoop;
using robust::batch::isa::NaiveLoops;

enum class Cases { random, one_in_a_hundred, near_degenerate };
constexpr Cases every_kind[] = {Cases::random, Cases::one_in_a_hundred, Cases::near_degenerate};
const char* name_of(Cases kind) {
  constexpr const char* names[] = {"random", "one_in_a_hundred_near", "near_degenerate"};
  return names[static_cast<std::size_t>(kind)];
}

struct Naive {
  const char* name;
  std::size_t columns;
  NaiveLoop* NaiveLoops::*loop;
};
constexpr Naive naive_formulas[] = {{"orientation", 6, &NaiveLoops::orientation},
                                    {"point_on_segment", 6, &NaiveLoops::point_on_segment},
                                    {"segment_segment", 8, &NaiveLoops::segment_segment},
                                    {"point_plane", 7, &NaiveLoops::point_plane},
                                    {"aabb_aabb", 8, &NaiveLoops::boxes_in_plane},
                                    {"aabb_aabb", 12, &NaiveLoops::boxes_in_space},
                                    {"sphere_sphere", 6, &NaiveLoops::spheres_in_plane},
                                    {"sphere_sphere", 8, &NaiveLoops::spheres_in_space},
                                    {"sphere_aabb", 7, &NaiveLoops::sphere_and_box_in_plane},
                                    {"sphere_aabb", 10, &NaiveLoops::sphere_and_box_in_space},
                                    {"ray_aabb", 8, &NaiveLoops::ray_and_box_in_plane},
                                    {"ray_aabb", 12, &NaiveLoops::ray_and_box_in_space}};

Word decision(const Operation& operation, const Question& question) {
  const auto& row = operation.row();
  return row.decide != nullptr ? row.decide(question, 0) : row.robust(question, 0).words.at(0);
}

bool accepted(const Operation& operation, const Question& question) {
  try {
    decision(operation, question);
  } catch (const InvalidInput&) {
    return false;
  }
  return true;
}

/// Families of full precision, or all hard cases where none says so by its name.
std::vector<std::size_t> near_misses(const Operation& operation) {
  std::vector<std::size_t> named, all;
  for (std::size_t i = 0; i < operation.families().size(); ++i) {
    const std::string& name = operation.families()[i];
    if (name.find('+') != std::string::npos) continue;
    if (i < operation.row().hard_cases.size()) all.push_back(i);
    if (name.starts_with("nearly") || name.starts_with("rounded")) named.push_back(i);
  }
  return named.empty() ? all : named;
}

/// case_count rows, all like `shape`: of one alternative and, where there are lists, of one list.
struct Table {
  Question shared;
  std::vector<std::vector<double>> numbers;
  std::vector<const double*> starts;
  std::vector<Column> columns;
  std::vector<std::size_t> places;

  Question row(std::size_t i) const {
    Question question = shared;
    for (std::size_t k = 0; k < places.size(); ++k) question.numbers[places[k]] = numbers[k][i];
    return question;
  }
};

Table drawn_table(const Operation& operation, const std::vector<Word>& words, Cases kind) {
  Table table;
  const auto& families = operation.families();
  const auto random =
      static_cast<std::size_t>(std::find(families.begin(), families.end(), "random") - families.begin());
  const std::vector<std::size_t> near = near_misses(operation);
  std::size_t rows = 0;
  for (std::uint64_t index = 0; rows < case_count; ++index) {
    catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, name_of(kind), index));
    const bool hard = kind == Cases::near_degenerate || (kind == Cases::one_in_a_hundred && rows % 100 == 0);
    const Question question = operation.draw(draws, hard ? near[draws.below(near.size())] : random);
    if (question.words != words || !accepted(operation, question)) continue;
    if (rows == 0) {
      table.shared = question;
      table.places = operation.row().batch.columns(question);
      table.numbers.resize(table.places.size());
      for (auto& column : table.numbers) column.reserve(case_count);
    }
    for (std::size_t k = 0; k < table.places.size(); ++k) table.numbers[k].push_back(question.numbers[table.places[k]]);
    ++rows;
  }
  for (const auto& column : table.numbers) {
    table.starts.push_back(column.data());
    table.columns.emplace_back(column.data(), 1);
  }
  return table;
}

/// The table asked for last.
const Table& table_of(const Operation& operation, const std::vector<Word>& words, Cases kind) {
  static std::string made;
  static Table table;
  std::string wanted = operation.name() + name_of(kind);
  for (const Word word : words) wanted += std::to_string(word) + " ";
  if (made != wanted) table = drawn_table(operation, words, kind), made = wanted;
  return table;
}

void done(benchmark::State& state, std::size_t rows = case_count) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(rows));
}

template <class Row>
concept HasEpick = requires {
  CgalPeer<Row>::only_epeck;
}
&&!CgalPeer<Row>::only_epeck;

template <class Row>
void add_row() {
  const Operation& operation = *catalogue::find_operation(Row::metadata().name);
  if (operation.row().batch.decide == nullptr) return;
  for (const Question& zeros : operation.zeros_of_alternatives()) {
    const std::vector<Word> words = zeros.words;
    const std::size_t columns = operation.row().batch.columns(zeros).size();
    if (columns != zeros.numbers.size()) continue;  // one list and many points: bench/polygons times rings
    const std::string alternative = words.empty() ? "" : "_" + std::to_string(words[0] + 2) + "d";
    for (const Cases kind : every_kind) {
      const std::string group = "arrays_" + operation.name() + alternative + "/" + name_of(kind) + "/";
      const auto add = [&](const char* peer, auto timed) {
        benchmark::RegisterBenchmark((group + peer).c_str(), timed);
      };
      const auto& operation_ = operation;
      const std::pair<const char*, Instructions> sets[] = {
          {"portable", Instructions::portable}, {"avx2", Instructions::avx2}, {"avx512", Instructions::avx512}};
      for (const auto& [name, set] : sets) {
        add(name, [=, &operation_, at_most = set](benchmark::State& state) {
          const Table& table = table_of(operation_, words, kind);
          std::vector<std::uint8_t> answers(case_count);
          for (auto _ : state) {
            operation_.row().batch.decide(table.shared, table.columns.data(), case_count, answers.data(), at_most);
            benchmark::ClobberMemory();
          }
          done(state);
        });
      }
      for (const Naive& formula : naive_formulas) {
        if (formula.name != operation.name() || formula.columns != columns) continue;
        const std::pair<const char*, const NaiveLoops*> loops[] = {{"naive", &robust::batch::isa::plain_loops},
                                                                   {"naive_avx2", &robust::batch::isa::avx2_loops},
                                                                   {"naive_avx512", &robust::batch::isa::avx512_loops}};
        for (const auto& [name, table_of_loops] : loops) {
          add(name, [=, &operation_, loop = table_of_loops->*formula.loop](benchmark::State& state) {
            const Table& table = table_of(operation_, words, kind);
            std::vector<std::uint8_t> answers(case_count);
            for (auto _ : state) {
              loop(table.starts.data(), case_count, answers.data());
              benchmark::ClobberMemory();
            }
            done(state);
          });
        }
      }
      if constexpr (HasEpick<Row>) {
        using Asked = typename Row::Question;
        add("epick", [=, &operation_](benchmark::State& state) {
          const auto shapes_of = [](const Asked& q) {
            return catalogue::applied(
                [](const auto&... field) { return CgalPeer<Row>::template shapes<Epick>(field...); }, q);
          };
          const Table& table = table_of(operation_, words, kind);
          std::vector<decltype(shapes_of(std::declval<const Asked&>()))> shapes;
          for (std::size_t i = 0; i < case_count; ++i)
            shapes.push_back(shapes_of(catalogue::unpacked<Asked>(table.row(i))));
          time_decisions(state, shapes, [](const auto& shape) {
            return catalogue::applied([](const auto&... each) { return CgalPeer<Row>::decide(each...); }, shape);
          });
        });
      }
    }
  }
}

constexpr std::size_t more_than_any_cache = std::size_t{1} << 22;

/// So many rows of random numbers in [0, 1), and the sum of them all.
void add_rows(const char* name, std::size_t columns, std::size_t rows) {
  const Operation& operation = *catalogue::find_operation(name);
  const std::string length = rows == more_than_any_cache ? "from_memory" : "rows_" + std::to_string(rows);
  const std::string group = std::string("arrays_") + name + "/" + length + "/";
  const auto numbers = [columns, rows]() -> const std::vector<double>& {
    static std::vector<double> made;
    if (made.size() != rows * columns) {
      made.resize(rows * columns);
      catalogue::DrawStream draws = catalogue::DrawStream::seeded(1);
      for (double& number : made) number = catalogue::ordinary(draws);
    }
    return made;
  };
  benchmark::RegisterBenchmark((group + "avx512").c_str(), [=, &operation](benchmark::State& state) {
    std::vector<Column> all;
    for (std::size_t k = 0; k < columns; ++k) all.emplace_back(numbers().data() + k * rows, 1);
    std::vector<std::uint8_t> answers(rows);
    for (auto _ : state) {
      operation.row().batch.decide(operation.zeros(), all.data(), rows, answers.data(), Instructions::avx512);
      benchmark::ClobberMemory();
    }
    done(state, rows);
  });
  for (const Naive& formula : naive_formulas) {
    if (formula.name != operation.name() || formula.columns != columns) continue;
    benchmark::RegisterBenchmark((group + "naive_avx512").c_str(), [=](benchmark::State& state) {
      std::vector<const double*> starts;
      for (std::size_t k = 0; k < columns; ++k) starts.push_back(numbers().data() + k * rows);
      std::vector<std::uint8_t> answers(rows);
      for (auto _ : state) {
        (robust::batch::isa::avx512_loops.*formula.loop)(starts.data(), rows, answers.data());
        benchmark::ClobberMemory();
      }
      done(state, rows);
    });
  }
  benchmark::RegisterBenchmark((group + "read").c_str(), [=](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(robust::batch::isa::sum_of(numbers().data(), rows * columns));
    done(state, rows);
  });
}

/// Prints a line for each table; false if an answer differs from robust's.
bool verified() {
  bool held = true;
  for (const Operation* operation : catalogue::all_operations()) {
    if (operation->row().batch.decide == nullptr) continue;
    for (const Question& zeros : operation->zeros_of_alternatives()) {
      if (operation->row().batch.columns(zeros).size() != zeros.numbers.size()) continue;
      for (const Cases kind : every_kind) {
        const Table& table = table_of(*operation, zeros.words, kind);
        std::size_t wrong = 0;
        for (const Instructions set : {Instructions::portable, Instructions::avx2, Instructions::avx512}) {
          std::vector<std::uint8_t> answers(case_count);
          operation->row().batch.decide(table.shared, table.columns.data(), case_count, answers.data(), set);
          for (std::size_t i = 0; i < case_count; ++i) wrong += answers[i] != decision(*operation, table.row(i));
        }
        held = held && wrong == 0;
        std::printf("%-18s %-22s %zu columns, wrong of %zu with three instruction sets: %zu\n",
                    operation->name().c_str(), name_of(kind), table.columns.size(), case_count, wrong);
      }
    }
  }
  return held;
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone;
  if (argc == 2 && std::strcmp(argv[1], "--verify") == 0) return bench::verified() ? 0 : 1;
  catalogue::for_each_row([]<class Row>() { bench::add_row<Row>(); });
  for (std::size_t rows = 1024; rows <= bench::more_than_any_cache; rows *= 8) {
    bench::add_rows("orientation", 6, rows);
    bench::add_rows("segment_segment", 8, rows);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
