// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>

#include "audit/audit_run.h"
#include "audit/engines/notes.h"
#include "audit/tally_json.h"
#include "catalogue/codec/excerpt.h"
#include "program/commands.h"
#include "program/program.h"
#include "report/table.h"
#include "report/wording.h"

namespace touchstone::program {
namespace {

struct Shard {
  std::uint64_t index = 1, of = 1;
};

Shard parsed(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, no_index] = std::from_chars(text.data(), end, shard.index);
  const bool cut = no_index == std::errc() && slash != end && *slash == '/';
  const auto [rest, no_count] = std::from_chars(cut ? slash + 1 : end, end, shard.of);
  if (!cut || no_count != std::errc() || rest != end || shard.index < 1 || shard.index > shard.of) {
    throw UsageError("--shard: expected I/N with 1 <= I <= N, got " + text);
  }
  return shard;
}

std::uint64_t configurations(const Operation& operation, int grid) {
  const auto total = operation.configurations(grid);
  if (!total) throw UsageError("--grid: expected fewer than 2^64 configurations, got more");
  return *total;
}

/// The share of shard I of N: consecutive indices; all shards together cover the range once.
std::uint64_t bound(std::uint64_t total, std::uint64_t i, std::uint64_t n) {
  return static_cast<std::uint64_t>(static_cast<unsigned __int128>(total) * i / n);
}

/// Our reference, or an engine that is asked many questions at a time, about the configurations of a grid.
class Answers {
 public:
  Answers(const Operation& operation, Engine* engine) : operation_(operation), engine_(engine) {}

  void add(std::uint64_t index, const Question& question, std::unique_ptr<Examination> examination) {
    if (engine_ == nullptr) {
      count(cell_, {operation_, question, examination->outcome(), index}, examination->judge_reference());
      return;
    }
    pending_.push_back({index, std::move(examination)});
    questions_.push_back(question);
    if (pending_.size() == at_once) ask();
  }
  void refuse(const std::string& rule) { cell_.refuse(rule); }
  const Cell& finish() {
    ask();
    return cell_;
  }

 private:
  static constexpr std::size_t at_once = 1024;
  struct Pending {
    std::uint64_t index;
    std::unique_ptr<Examination> examination;
  };

  void ask() {
    if (pending_.empty()) return;
    const std::vector<Reply> replies = engine_->ask(operation_, questions_);
    for (std::size_t i = 0; i < pending_.size(); ++i) {
      const Examination& examination = *pending_[i].examination;
      if (replies[i].asked) {
        count(cell_, {operation_, questions_[i], examination.outcome(), pending_[i].index},
              judged(replies[i], examination, engine_->declaration()), replies[i].answer);
      } else {
        ++cell_.not_asked;
        cell_.given_up = replies[i].remark;
      }
    }
    pending_.clear();
    questions_.clear();
  }

  const Operation& operation_;
  Engine* engine_;
  Cell cell_;
  std::vector<Pending> pending_;
  std::vector<Question> questions_;
};

Tally examined(const Operation& operation, int grid, const Shard& shard, Engine* engine) {
  const std::uint64_t total = configurations(operation, grid);
  Tally tally;
  tally.declaration =
      engine != nullptr ? engine->declaration() : Declaration{"reference", Declaration::Boundary::closed, false, 0};
  tally.cases = total;
  tally.grid = {static_cast<std::uint64_t>(grid), shard.of, {shard.index}};
  Answers answers(operation, engine);
  Cell of_robust;
  for (std::uint64_t i = bound(total, shard.index - 1, shard.of); i < bound(total, shard.index, shard.of); ++i) {
    const Question question = operation.on_grid(grid, i);
    try {
      auto examination = operation.examine(question);
      count(of_robust, {operation, question, examination->outcome(), i}, examination->judge_robust());
      answers.add(i, question, std::move(examination));
    } catch (const InvalidInput& refused) {
      answers.refuse(refused.rule());
      of_robust.refuse(refused.rule());
      const std::string mismatch = operation.refusal_mismatch(question);
      if (!mismatch.empty()) count(of_robust, {operation, question, "refused", i}, {Verdict::invalid, 0, mismatch, 0});
    }
  }
  const std::string family = fmt::format("{0}-grid", grid);
  tally.operations.push_back({operation.name(), {{family, answers.finish()}}});
  tally.robust.push_back({operation.name(), {{family, of_robust}}});
  return tally;
}

int decisions_only(const Operation& operation, int grid, const Shard& shard, const std::string& json_file,
                   std::ostream& out) {
  const std::uint64_t total = configurations(operation, grid);
  const std::uint64_t first = bound(total, shard.index - 1, shard.of), last = bound(total, shard.index, shard.of);
  const auto count = operation.count_decisions(grid, first, last);
  if (!count)
    throw UsageError("--decisions: expected an operation with a fast pair of decisions (segment_segment, orientation)");
  Json line = Json::object();
  line["touchstone"] = 1;
  line["op"] = operation.name();
  line["grid"] = grid;
  line["shard"] = fmt::format("{}/{}", shard.index, shard.of);
  line["first"] = first;
  line["last"] = last;
  line["of"] = total;
  line["outcomes"] = count->outcomes;
  line["wrong"] = count->wrong;
  line["hash"] = fmt::format("{:016x}", count->hash);
  if (count->wrong > 0) line["first_wrong"] = operation.print(operation.on_grid(grid, count->first_wrong));
  if (!is_standard_output(json_file)) out << one_line(line) << '\n';
  write_file("--json", json_file, one_line(line) + "\n");
  return count->wrong > 0 ? findings : nothing_found;
}

/// Adds the lines of `--decisions` shards; refuses gaps and overlaps.
Json merged_decisions(std::vector<Json> parts) {
  std::sort(parts.begin(), parts.end(), [](const Json& a, const Json& b) { return a["first"] < b["first"]; });
  Json sum = parts[0];
  std::uint64_t reached = 0, hash = 0, wrong = 0;
  std::map<std::string, std::uint64_t> outcomes;
  for (const Json& part : parts) {
    if (part["op"] != sum["op"] || part["grid"] != sum["grid"])
      throw UsageError("merge: results of one operation and grid");
    if (part["first"] != reached)
      throw UsageError(
          fmt::format("merge: configurations from {} on, found {}", reached, excerpt(part["first"].dump(), 60)));
    reached = part["last"];
    hash += std::stoull(part["hash"].get<std::string>(), nullptr, 16);
    wrong += part["wrong"].get<std::uint64_t>();
    for (const auto& [word, n] : part["outcomes"].items()) outcomes[word] += n.get<std::uint64_t>();
    if (part.contains("first_wrong") && !sum.contains("first_wrong")) sum["first_wrong"] = part["first_wrong"];
  }
  if (reached != sum["of"].get<std::uint64_t>())
    throw UsageError(fmt::format("merge: configurations up to {}, found {}", excerpt(sum["of"].dump(), 60), reached));
  sum["shard"] = "1/1";
  sum["first"] = 0;
  sum["last"] = reached;
  sum["outcomes"] = outcomes;
  sum["wrong"] = wrong;
  sum["hash"] = fmt::format("{:016x}", hash);
  return sum;
}

}  // namespace

int exhaust_command(const ExhaustCommand& command, std::ostream& out, std::ostream& err) {
  const Operation& operation = operation_named(command.operation);
  const Shard shard = parsed(command.shard);
  require_writable("--json", command.json_file);
  if (command.decisions && !command.engine.empty())
    throw UsageError("--decisions: expected without --engine, whose answers are no decisions alone");
  if (command.decisions) return decisions_only(operation, command.grid, shard, command.json_file, out);
  EngineNotes notes;
  const std::unique_ptr<Engine> engine = engine_for(operation, command.engine, command.timeout, notes);
  Tally tally = examined(operation, command.grid, shard, engine.get());
  notes.tell(err);
  tally.repeat = repeat_of(command.program, command.engine, command.timeout);
  (is_standard_output(command.json_file) ? err : out) << text_table(tally);
  write_file("--json", command.json_file, tally_json(tally));
  if (tally.has_findings()) return findings;
  if (shard.of > 1 || sum_of(tally.operations).cases() > 0) return nothing_found;  // a shard of many may be empty
  err << "touchstone: nothing was judged: no configuration on this grid is within the contract\n";
  return bad_usage;
}

int merge_command(const std::vector<std::string>& files, std::ostream& out, std::ostream& err) {
  std::vector<Json> decisions;
  std::optional<Tally> sum;
  for (const std::string& file : files) {
    each_line(file, [&](std::uint64_t number, const std::string& text) {
      try {
        const Json line = parse_own_line(text);
        if (!line.is_object()) throw InvalidInput("line", "one JSON object");
        if (line.contains("hash")) {
          decisions.push_back(line);
          return;
        }
        const Tally part = read_tally(text);
        sum ? sum->merge(part) : static_cast<void>(sum = std::move(part));
      } catch (const InvalidInput& refused) {
        throw UsageError(file + ": line " + std::to_string(number) + ": " + refused.what());
      }
    });
  }
  if (!decisions.empty()) {
    const Json total = merged_decisions(decisions);
    out << one_line(total) << '\n';
    return total["wrong"] > 0 ? findings : nothing_found;
  }
  if (!sum) throw UsageError("merge: at least one result of exhaust --json or audit --json");
  out << text_table(*sum);
  if (sum->grid.size > 0 && sum->grid.done.size() < sum->grid.shards) {
    err << fmt::format("touchstone: merge: {} of {} shards are missing\n", sum->grid.shards - sum->grid.done.size(),
                       sum->grid.shards);
    return bad_usage;
  }
  return sum->has_findings() ? findings : nothing_found;
}

}  // namespace touchstone::program
