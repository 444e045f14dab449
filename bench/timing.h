// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace touchstone::bench {

#if !defined(__OPTIMIZE__)
/// Before anything runs.
inline const int said = std::fputs(
    "compiled without optimisation, so that it keeps compiling: its times mean nothing (./dev bench compiles it to "
    "run)\n",
    stderr);
#endif

/// Cases of one iteration of Google Benchmark, so that its own loop costs nothing.
inline constexpr std::size_t chunk = 4096;

/// One case at a time: without this the compiler would compute a plain formula for several cases at once, and nobody
/// who has one question can do that. Costs no instruction.
inline void keep(int& total) { asm volatile("" : "+r"(total)); }

/// ask(cases[i]) for all cases in turn, again and again; ask answers an int. items_per_second are cases.
template <class Cases, class Ask>
void time_decisions(benchmark::State& state, const Cases& cases, const Ask& ask) {
  std::size_t next = 0;
  int total = 0;
  for (auto _ : state) {
    const std::size_t last = next + chunk;
    for (; next < last; ++next) {
      total += ask(cases[next]);
      keep(total);
    }
    if (next + chunk > cases.size()) next = 0;
  }
  benchmark::DoNotOptimize(total);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(chunk));
}

/// The same where ask answers anything; it is made in full.
template <class Cases, class Ask>
void time_answers(benchmark::State& state, const Cases& cases, const Ask& ask) {
  std::size_t next = 0;
  for (auto _ : state) {
    const std::size_t last = next + chunk / 16;
    for (; next < last; ++next) benchmark::DoNotOptimize(ask(cases[next]));
    if (next + chunk > cases.size()) next = 0;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(chunk / 16));
}

}  // namespace touchstone::bench
