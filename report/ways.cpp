// SPDX-License-Identifier: Apache-2.0
#include "report/ways.h"

#include <algorithm>
#include <map>

namespace touchstone::report {
namespace {

int rank(Verdict verdict) { return !is_finding(verdict) ? 2 : verdict == Verdict::inexact ? 1 : 0; }

}  // namespace

std::vector<WayOfOperation> ways_of(const OperationTally& tally) {
  std::map<Way, WayOfOperation> by_way;
  for (const auto& [family, cell] : tally.families) {
    for (const auto& [way, counted] : cell.ways) {
      if (!counted.example) continue;
      WayOfOperation& sum = by_way[way];
      if (!sum.counted.example || shown_before(*counted.example, *sum.counted.example)) sum.family = family;
      sum.way = way;
      sum.counted.merge(counted);
    }
  }
  std::vector<WayOfOperation> ways;
  for (auto& [way, sum] : by_way) ways.push_back(std::move(sum));
  std::stable_sort(ways.begin(), ways.end(), [](const WayOfOperation& a, const WayOfOperation& b) {
    const int rank_a = rank(a.way.verdict), rank_b = rank(b.way.verdict);
    return rank_a != rank_b ? rank_a < rank_b : a.counted.cases > b.counted.cases;
  });
  return ways;
}

}  // namespace touchstone::report
