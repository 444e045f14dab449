// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace touchstone::bench {

#if !defined(__OPTIMIZE__)
/// Printed before anything runs.
inline const int said = std::fputs(
    "compiled without optimisation, so that it keeps compiling: its times mean nothing (./dev bench compiles it to "
    "run)\n",
    stderr);
#endif

/// Cases per iteration of Google Benchmark, so that its own loop costs nothing.
inline constexpr std::size_t chunk = 4096;

/// Makes the loop take one case at a time: otherwise the compiler would compute a plain formula for several cases at
/// once, which a caller with one question cannot do. Costs no instruction.
inline void keep(int& total) { asm volatile("" : "+r"(total)); }

/// Calls ask(cases[i]) for all cases in turn, repeatedly; ask returns an int. items_per_second counts cases.
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

/// The same if ask returns anything else; the value is computed in full.
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
