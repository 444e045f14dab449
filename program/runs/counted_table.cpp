// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "audit/counted.h"
#include "catalogue/codec/excerpt.h"
#include "program/runs/counted_run.h"

namespace touchstone::program {

std::string table_of(const CountedRun& run) {
  constexpr const char* row = "{:<35}{:>18}{:>16}{:>8}  {}\n";
  std::string text = fmt::format(row, "operation", "cases", "refused", "wrong", "hash");
  std::string wrong;
  std::uint64_t cases = 0, refused = 0, hash = 0;
  for (const Counts& counts : run.operations) {
    const auto found = counts.outcomes.find("refused");
    const std::uint64_t outside = found == counts.outcomes.end() ? 0 : found->second;
    text += fmt::format(row, counts.operation, grouped(counts.cases()), grouped(outside), grouped(counts.wrong),
                        fmt::format("{:016x}", counts.hash));
    cases += counts.cases(), refused += outside, hash += counts.hash;
    if (counts.wrong == 0) continue;
    wrong += fmt::format("{}: robust and oracle differ: {}\n  echo '{}' | touchstone ask {} -\n", counts.operation,
                         excerpt(counts.first_wrong.value("remark", ""), 500),
                         one_line(counts.first_wrong.value("input", Json())), counts.operation);
  }
  text += fmt::format(row, "sum", grouped(cases), grouped(refused), grouped(run.wrong()), fmt::format("{:016x}", hash));
  return text + wrong;
}

}  // namespace touchstone::program
