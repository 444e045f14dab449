// SPDX-License-Identifier: Apache-2.0
// Decisions over arrays: every operation of the catalogue that has them, compared with the naive formula over the same
// columns (one row at a time, and in the lanes of the same instruction sets), and with robust, CGAL's Epick and
// Shewchuk's predicates, one question at a time.
// Large arrays are also timed from memory, where the cache is too small, compared with the rate at which that memory
// can be read.
//
// bench/arrays --verify compares all array answers with robust, one question at a time, without timing.

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "bench/array_tables.h"
#include "bench/isa/naive_loops.h"
#include "bench/peers_of_arrays.h"
#include "bench/shewchuk.h"
#include "bench/timing.h"

namespace touchstone::bench {
namespace {

using robust::batch::Instructions;
using robust::batch::isa::NaiveLoop;
using robust::batch::isa::NaiveLoops;
using robust::batch::isa::NaiveSharedLoop;

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
                                    {"ray_aabb", 12, &NaiveLoops::ray_and_box_in_space},
                                    {"sphere_obb", 16, &NaiveLoops::sphere_obb},
                                    {"capsule_capsule", 14, &NaiveLoops::capsule_capsule},
                                    {"obb_obb", 24, &NaiveLoops::obb_obb},
                                    {"ray_triangle", 15, &NaiveLoops::ray_triangle},
                                    {"segment_triangle", 15, &NaiveLoops::segment_triangle},
                                    {"triangle_triangle", 18, &NaiveLoops::triangle_triangle}};

/// For operations that ask about points and one shape.
struct NaiveBeside {
  const char* name;
  NaiveSharedLoop* NaiveLoops::*loop;
};
constexpr NaiveBeside naive_formulas_beside[] = {{"point_in_polygon", &NaiveLoops::point_in_ring},
                                                 {"point_in_convex_polygon", &NaiveLoops::point_in_convex_ring},
                                                 {"point_in_convex_polyhedron", &NaiveLoops::point_in_convex_solid},
                                                 {"point_in_polyhedron", &NaiveLoops::point_in_solid}};

void done(benchmark::State& state, std::size_t rows = case_count) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(rows));
}

/// One of the tables of an operation.
struct Asked {
  const Operation& operation;
  std::vector<Word> words;
  Cases kind;
  const Table& table() const { return table_of(operation, words, kind); }
};

template <class Timed>
void add(const std::string& name, const Timed& timed) {
  benchmark::RegisterBenchmark(name.c_str(), timed);
}

/// Calls ask(answers) repeatedly.
template <class Ask>
void time_arrays(benchmark::State& state, std::size_t rows, const Ask& ask) {
  std::vector<std::uint8_t> answers(rows);
  for (auto _ : state) {
    ask(answers.data());
    benchmark::ClobberMemory();
  }
  done(state, rows);
}

void add_ours(const std::string& group, const Asked& asked) {
  const std::pair<const char*, Instructions> sets[] = {
      {"portable", Instructions::portable}, {"avx2", Instructions::avx2}, {"avx512", Instructions::avx512}};
  for (const auto& [name, set] : sets) {
    add(group + name, [=, at_most = set](benchmark::State& state) {
      const Table& table = asked.table();
      time_arrays(state, case_count, [&](std::uint8_t* answers) {
        asked.operation.row().batch.decide(table.shared, table.columns.data(), case_count, answers, at_most);
      });
    });
  }
}

void add_naive(const std::string& group, const Asked& asked, std::size_t columns) {
  using namespace robust::batch::isa;
  const std::pair<const char*, const NaiveLoops*> loops[] = {
      {"naive", &plain_loops}, {"naive_avx2", &avx2_loops}, {"naive_avx512", &avx512_loops}};
  for (const auto& [name, own_loops] : loops) {
    for (const Naive& formula : naive_formulas) {
      if (formula.name != asked.operation.name() || formula.columns != columns) continue;
      add(group + name, [=, loop = own_loops->*formula.loop](benchmark::State& state) {
        const Table& table = asked.table();
        time_arrays(state, case_count, [&](std::uint8_t* answers) { loop(table.starts.data(), case_count, answers); });
      });
    }
    for (const NaiveBeside& formula : naive_formulas_beside) {
      if (formula.name != asked.operation.name()) continue;
      add(group + name, [=, loop = own_loops->*formula.loop](benchmark::State& state) {
        const Table& table = asked.table();
        const SharedShape& shape = *shape_of(asked.operation);
        time_arrays(state, case_count, [&](std::uint8_t* answers) {
          loop(table.starts.data(), Shared{shape.numbers.data(), shape.count}, case_count, answers);
        });
      });
    }
  }
}

template <class Row>
concept HasEpick = requires {
  CgalPeer<Row>::only_epeck;
}
&&!CgalPeer<Row>::only_epeck;

/// `Question` is Row's, or one of its alternatives: a tuple.
template <class Row, class Question>
void add_epick(const std::string& group, const Asked& asked) {
  add(group + "epick", [=](benchmark::State& state) {
    const auto question_of = [](const catalogue::Question& encoded) {
      const auto question = catalogue::unpacked<typename Row::Question>(encoded);
      if constexpr (std::is_same_v<typename Row::Question, Question>) return question;
      else return std::get<Question>(question);
    };
    const auto shapes_of = [](const Question& q) {
      return catalogue::applied([](const auto&... field) { return CgalPeer<Row>::template shapes<Epick>(field...); },
                                q);
    };
    const Table& table = asked.table();
    std::vector<decltype(shapes_of(std::declval<const Question&>()))> shapes;
    for (std::size_t i = 0; i < case_count; ++i) shapes.push_back(shapes_of(question_of(table.row(i))));
    time_decisions(state, shapes, [](const auto& shape) {
      return catalogue::applied([](const auto&... each) { return CgalPeer<Row>::decide(each...); }, shape);
    });
  });
}

template <class Shape, class Point>
void add_epick_beside(const std::string& group, const Asked& asked) {
  add(group + "epick", [=](benchmark::State& state) {
    const Table& table = asked.table();
    using Question = std::tuple<Shape, Point>;
    const CgalBeside<Shape> shape(std::get<0>(catalogue::unpacked<Question>(table.shared)));
    std::vector<decltype(cgal<Epick>(std::declval<const Point&>()))> points;
    Point p;
    for (std::size_t i = 0; i < case_count; ++i) {
      p.x = table.numbers[0][i], p.y = table.numbers[1][i];
      if constexpr (std::is_same_v<Point, Point3d>) p.z = table.numbers[2][i];
      points.push_back(cgal<Epick>(p));
    }
    time_decisions(state, points, [&](const auto& point) { return shape.decide(point); });
  });
}

#ifdef TOUCHSTONE_BENCH_TET
void add_shewchuk(const std::string& group, const Asked& asked) {
  if (asked.operation.name() != "orientation") return;
  add(group + "shewchuk", [=](benchmark::State& state) {
    const Table& table = asked.table();
    using Points = std::array<Point2d, 3>;
    std::vector<Points> rows;
    for (std::size_t i = 0; i < case_count; ++i) {
      const auto at = [&](std::size_t k) { return Point2d{table.numbers[2 * k][i], table.numbers[2 * k + 1][i]}; };
      rows.push_back({at(0), at(1), at(2)});
    }
    time_decisions(state, rows, [](const Points& row) { return side_by_shewchuk(row[0], row[1], row[2]); });
  });
}
#else
void add_shewchuk(const std::string&, const Asked&) {}
#endif

/// The types that CGAL has for a question.
template <class Row, class Question>
struct EpickOf {
  static void add(const std::string& group, const Asked& asked) {
    // If rounding makes the second point of CGAL's ray equal to the first, CGAL divides by 0, and the program ends.
    const bool rays = std::string_view(Row::metadata.name).starts_with("ray_");
    if (rays && asked.kind == Cases::hard) return;
    if constexpr (HasEpick<Row>) add_epick<Row, Question>(group, asked);
  }
};
template <class Row, class... Alternatives>
struct EpickOf<Row, std::variant<Alternatives...>> {
  static void add(const std::string& group, const Asked& asked) {
    Word at = 0;
    ((asked.words[0] == at++ ? EpickOf<Row, Alternatives>::add(group, asked) : void()), ...);
  }
};
template <class Row>
struct EpickOf<Row, std::tuple<Polygon2d, Point2d>> {
  static void add(const std::string& group, const Asked& asked) { add_epick_beside<Polygon2d, Point2d>(group, asked); }
};
template <class Row>
struct EpickOf<Row, std::tuple<Meshd, Point3d>> {
  static void add(const std::string& group, const Asked& asked) { add_epick_beside<Meshd, Point3d>(group, asked); }
};

/// The enumerators of the tables: one for each alternative, or that of the shape that all rows share. Rays on meshes
/// have benchmarks of their own (mesh_rays.cpp).
std::vector<std::vector<Word>> words_of_tables(const Operation& operation) {
  if (operation.row().batch.decide == nullptr || operation.name() == "ray_mesh") return {};
  if (const SharedShape* const shape = shape_of(operation)) return {shape->question.words};
  std::vector<std::vector<Word>> found;
  for (const Question& zeros : operation.zeros_of_alternatives()) found.push_back(zeros.words);
  return found;
}

template <class Row>
void add_row() {
  const Operation& operation = *catalogue::find_operation(Row::metadata.name);
  for (const std::vector<Word>& words : words_of_tables(operation)) {
    const bool several = shape_of(operation) == nullptr && !words.empty();
    const std::string alternative = several ? "_" + std::to_string(words[0] + 2) + "d" : "";
    for (const Cases kind : kinds_of(operation)) {
      const std::string group = "arrays_" + operation.name() + alternative + "/" + name_of(kind) + "/";
      const Asked asked{operation, words, kind};
      add_ours(group, asked);
      std::size_t columns = 0;
      for (const Question& zeros : operation.zeros_of_alternatives())
        if (zeros.words == words) columns = operation.row().batch.columns(zeros).size();
      add_naive(group, asked, columns);
      EpickOf<Row, typename Row::Question>::add(group, asked);
      add_shewchuk(group, asked);
    }
  }
}

constexpr std::size_t more_than_any_cache = std::size_t{1} << 22;

/// Adds benchmarks over `rows` rows of random numbers in [0, 1), and of adding them all up.
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
    time_arrays(state, rows, [&](std::uint8_t* answers) {
      operation.row().batch.decide(operation.zeros(), all.data(), rows, answers, Instructions::avx512);
    });
  });
  for (const Naive& formula : naive_formulas) {
    if (formula.name != operation.name() || formula.columns != columns) continue;
    benchmark::RegisterBenchmark((group + "naive_avx512").c_str(), [=](benchmark::State& state) {
      std::vector<const double*> starts;
      for (std::size_t k = 0; k < columns; ++k) starts.push_back(numbers().data() + k * rows);
      time_arrays(state, rows, [&](std::uint8_t* answers) {
        (robust::batch::isa::avx512_loops.*formula.loop)(starts.data(), rows, answers);
      });
    });
  }
  benchmark::RegisterBenchmark((group + "read").c_str(), [=](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(robust::batch::isa::sum_of(numbers().data(), rows * columns));
    done(state, rows);
  });
}

/// Prints a line for each table; returns false if an answer differs from robust's.
bool verified() {
  bool held = true;
  for (const Operation* operation : catalogue::all_operations()) {
    for (const std::vector<Word>& words : words_of_tables(*operation)) {
      for (const Cases kind : kinds_of(*operation)) {
        const Table& table = table_of(*operation, words, kind);
        std::size_t wrong = 0;
        for (const Instructions set : {Instructions::portable, Instructions::avx2, Instructions::avx512}) {
          std::vector<std::uint8_t> answers(case_count);
          operation->row().batch.decide(table.shared, table.columns.data(), case_count, answers.data(), set);
          for (std::size_t i = 0; i < case_count; ++i) wrong += answers[i] != decision(*operation, table.row(i));
        }
        held = held && wrong == 0;
        std::printf("%-26s %-22s %zu columns, wrong of %zu with three instruction sets: %zu\n",
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
