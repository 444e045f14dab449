// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <optional>

#include "audit/counting/tally_json.h"
#include "audit/place.h"
#include "program/commands/commands.h"
#include "program/runs/counted_run.h"
#include "report/screen/table.h"

namespace touchstone::program {
namespace {

/// Requires that the questions asked are those of the shards: for a grid all of them, for drawn cases no more than
/// those.
void require_shares(const Tally& tally) {
  if (!tally.logs.empty()) return;  // the length of a log is only known at its end
  std::uint64_t share = 0;
  for (const std::uint64_t shard : tally.grid.done) share += share_of(tally.cases, {shard, tally.grid.shards}).size();
  for (const OperationTally& operation : tally.operations) {
    const Cell sum = operation.total();
    const std::uint64_t asked = sum.cases() + sum.refused + sum.left_out + sum.other_alternative + sum.not_asked;
    if (tally.grid.size > 0 ? asked != share : tally.grid.shards > 1 && asked > share)
      throw InvalidInput("operations", fmt::format("of {} {} cases, which is what the shards hold, got {}",
                                                   operation.operation, share, asked));
  }
}

/// The combined content of files of one kind.
struct Merged {
  std::optional<Tally> tally;
  std::optional<CountedRun> counted;

  void add(const std::string& text) {
    const Json line = parse_line(text);
    if (Place{line, ""}.at("touchstone").count() != 1) throw InvalidInput("touchstone", "version 1");
    if (Place{line, ""}.at("kind").text() == "tally") {
      const Tally part = read_tally(text);
      require_shares(part);
      if (counted) throw InvalidInput("kind", "the same in every file");
      tally ? tally->merge(part) : static_cast<void>(tally = part);
    } else {
      const CountedRun part = read_counted_run(line);
      require_shares(part);
      if (tally) throw InvalidInput("kind", "the same in every file");
      counted ? counted->merge(part) : static_cast<void>(counted = part);
    }
  }
};

}  // namespace

int merge_command(const MergeCommand& command, std::ostream& out, std::ostream& err) {
  require_writable("--json", command.json_file);
  Merged merged;
  for (const std::string& file : command.files) {
    each_line(file, [&](std::uint64_t number, const std::string& text) {
      try {
        merged.add(text);
      } catch (const InvalidInput& refused) {
        throw UsageError(file + ": line " + std::to_string(number) + ": " + refused.what());
      }
    });
  }
  if (!merged.tally && !merged.counted) throw UsageError("merge: at least one result of exhaust, audit or soak --json");
  std::ostream& readable = is_standard_output(command.json_file) ? err : out;
  std::string missing, json;
  bool found = false;
  if (merged.tally) {
    readable << text_table(*merged.tally);
    json = tally_json(*merged.tally);
    const Grid& grid = merged.tally->grid;
    if (grid.size > 0 || grid.shards > 1) missing = missing_shards(grid.shards, grid.done);
    found = merged.tally->has_findings();
  } else {
    require_full_grid(*merged.counted);
    json = one_line(json_of(*merged.counted)) + "\n";
    readable << (merged.counted->kind == "soak" ? table_of(*merged.counted) : json);
    missing = missing_shards(merged.counted->shards, merged.counted->done);
    found = merged.counted->wrong() > 0;
  }
  write_file("--json", command.json_file, json);
  if (!missing.empty()) {
    err << "touchstone: merge: " << missing << '\n';
    return bad_usage;
  }
  return found ? findings : nothing_found;
}

}  // namespace touchstone::program
