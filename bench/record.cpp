// SPDX-License-Identifier: Apache-2.0
// Tests a pair of segments by the formula in double, and records it by touchstone_record.h and touchstone/record.h, or
// prints and writes it by the C library, into a file that is truncated every two million calls. items_per_second counts
// calls; the cost of recording is the difference to `tested`.
#include "c/record.h"

#include <array>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "bench/timing.h"

namespace touchstone::bench {
namespace {

using Pair = std::array<double, 8>;

const std::vector<Pair>& pairs() {
  static const std::vector<Pair> made = [] {
    std::mt19937_64 bits(1);
    std::vector<Pair> all(1 << 17);
    for (Pair& pair : all)
      for (double& number : pair) number = static_cast<double>(bits() >> 11) * 0x1p-53;
    return all;
  }();
  return made;
}

double side(const double* p, const double* q, const double* r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}
/// Without branches, like the other benchmarks.
bool meet(const Pair& s) {
  const double *a = &s[0], *b = &s[2], *c = &s[4], *d = &s[6];
  return (int{side(a, b, c) * side(a, b, d) <= 0} & int{side(c, d, a) * side(c, d, b) <= 0}) != 0;
}

std::string place() {
  return (std::filesystem::temp_directory_path() / ("touchstone_bench_record_" + std::to_string(::getpid()))).string();
}

/// Calls ask(pair) for chunks of pairs; begin() truncates the file and is not timed.
template <class Begin, class Ask>
void time_calls(benchmark::State& state, const Begin& begin, const Ask& ask) {
  constexpr std::size_t most = 2'000'000;
  const std::vector<Pair>& all = pairs();
  std::size_t next = 0, written = 0;
  int total = 0;
  begin();
  for (auto _ : state) {
    for (const std::size_t last = next + chunk; next < last; ++next) {
      total += ask(all[next]);
      keep(total);
    }
    if (next + chunk > all.size()) next = 0;
    if ((written += chunk) < most) continue;
    state.PauseTiming();
    begin();
    written = 0;
    state.ResumeTiming();
  }
  benchmark::DoNotOptimize(total);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(chunk));
}

void tested(benchmark::State& state) {
  time_calls(
      state, [] {}, meet);
}

int recorded_in_c(const Pair& pair) {
  const bool hit = meet(pair);
  TOUCHSTONE_RECORD_DOUBLES("segment_segment", pair.data(), 8, TOUCHSTONE_RECORD_FLAG, hit);
  return hit;
}

int recorded_in_cpp(const Pair& s) {
  const Segment2d a{{s[0], s[1]}, {s[2], s[3]}}, b{{s[4], s[5]}, {s[6], s[7]}};
  return record(
      "segment_segment", [&] { return meet(s); }, a, b);
}

template <int (*recorded)(const Pair&)>
void time_recorder(benchmark::State& state, std::uint64_t one_in, const std::string& file = place()) {
  touchstone_record_options options{};
  options.one_in = one_in;
  time_calls(
      state, [&] { touchstone_record_open(file.c_str(), &options); }, recorded);
  if (touchstone_record_close() != 0) state.SkipWithError("the log could not be written");
  if (file == place()) std::filesystem::remove(file);
}
/// Records into a file that keeps nothing: the cost of the recorder itself.
void record_c_to_null(benchmark::State& state) { time_recorder<recorded_in_c>(state, 1, "/dev/null"); }
void record_cpp_to_null(benchmark::State& state) { time_recorder<recorded_in_cpp>(state, 1, "/dev/null"); }
void record_c(benchmark::State& state) { time_recorder<recorded_in_c>(state, 1); }
void record_cpp(benchmark::State& state) { time_recorder<recorded_in_cpp>(state, 1); }
void record_c_one_in_1000(benchmark::State& state) { time_recorder<recorded_in_c>(state, 1000); }
void record_cpp_one_in_1000(benchmark::State& state) { time_recorder<recorded_in_cpp>(state, 1000); }
void record_c_closed(benchmark::State& state) {
  time_calls(
      state, [] {}, recorded_in_c);
}

/// The same call through the C library; no other thread shares the file.
template <class Put>
void time_stdio(benchmark::State& state, const Put& put) {
  const std::string file = place();
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (out == nullptr) return state.SkipWithError("the file could not be written");
  time_calls(
      state, [&] { out = std::freopen(file.c_str(), "wb", out); },
      [&](const Pair& pair) {
        const bool hit = meet(pair);
        put(out, pair, hit);
        return int{hit};
      });
  std::fclose(out);
  std::filesystem::remove(file);
}
void fwrite_of_the_same(benchmark::State& state) {
  time_stdio(state, [](std::FILE* out, const Pair& pair, bool hit) {
    std::fwrite(pair.data(), sizeof(double), pair.size(), out);
    std::putc(hit, out);
  });
}
void fprintf_of_the_same(benchmark::State& state) {
  time_stdio(state, [](std::FILE* out, const Pair& s, bool hit) {
    std::fprintf(out, "segment_segment %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %d\n", s[0], s[1], s[2], s[3],
                 s[4], s[5], s[6], s[7], hit);
  });
}

BENCHMARK(tested);
BENCHMARK(record_c_closed);
BENCHMARK(record_c_one_in_1000);
BENCHMARK(record_cpp_one_in_1000);
BENCHMARK(record_c_to_null);
BENCHMARK(record_cpp_to_null);
BENCHMARK(record_c);
BENCHMARK(record_cpp);
BENCHMARK(fwrite_of_the_same);
BENCHMARK(fprintf_of_the_same);

}  // namespace
}  // namespace touchstone::bench
BENCHMARK_MAIN();
