// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/audit_run.h"

#include <algorithm>

#include "audit/counting/cases_of.h"
#include "audit/counting/generic.h"
#include "audit/counting/shrink_examples.h"
#include "audit/parallel.h"
#include "catalogue/codec/plain.h"
#include "catalogue/operation/probes/fitted.h"
#include "geometry/int128.h"

namespace touchstone::audit {
namespace {

constexpr std::uint64_t batch_size = 1024;
/// Used under a time limit: when it expires, at most one such batch remains to be judged.
constexpr std::uint64_t limited_batch_size = 64;

/// One job: a share of the batches of one operation.
class Worker {
 public:
  Worker(const AuditOptions& options, const Operation& operation, const std::vector<std::size_t>& families,
         Engine* engine, const TimeLimit& limit, const std::atomic<bool>& stop)
      : options_(options),
        operation_(operation),
        families_(families),
        engine_(engine),
        limit_(limit),
        stop_(stop),
        asked_(families.size()),
        robust_(families.size()) {}

  void run_batch(std::uint64_t first, std::uint64_t last) {
    std::vector<Pending> pending;
    for (std::uint64_t i = first; i < last && !limit_.over(); ++i) prepare(i, pending);
    std::vector<JudgedReply> replies(pending.size());
    if (engine_ != nullptr) {
      std::vector<Question> questions;
      for (const Pending& p : pending) questions.push_back(p.question);
      engine_->ask_each(operation_, questions, [&](std::size_t i, const Reply& reply) {
        replies[i] = judged_and_kept(reply, *pending[i].examination, engine_->declaration());
      });
    }
    for (std::size_t i = 0; i < pending.size(); ++i) {
      if (engine_ == nullptr && limit_.over()) break;  // an engine's answers are judged in any case
      Pending& p = pending[i];
      const Asked asked{operation_, p.question, p.examination->outcome(), p.index, options_.limits};
      if (engine_ == nullptr) {
        const Judgement& judgement = p.examination->judge_reference();
        count(asked_[p.family], asked, judgement, is_shown(judgement) ? p.examination->reference() : Json());
      } else {
        const JudgedReply& reply = replies[i];
        if (!reply.asked && (stop_ || limit_.over())) continue;
        if (reply.asked) {
          count(asked_[p.family], asked, reply.judgement, reply.answer);
        } else {
          ++asked_[p.family].not_asked;
          asked_[p.family].given_up = reply.judgement.remark;
        }
      }
      const Judgement& judgement = p.examination->judge_robust();
      count(robust_[p.family], asked, judgement, is_shown(judgement) ? p.examination->robust() : Json());
      p.examination.reset();  // and all its computed values
    }
  }

  const std::vector<Cell>& asked() const { return asked_; }
  const std::vector<Cell>& robust() const { return robust_; }

 private:
  struct Pending {
    std::size_t family;
    std::uint64_t index;
    Question question;
    std::unique_ptr<Examination> examination;
  };

  void prepare(std::uint64_t i, std::vector<Pending>& pending) {
    const std::size_t family = i % families_.size();
    const std::uint64_t index = i / families_.size();
    DrawStream draws = case_draws(operation_, families_[family], options_.seed, index);
    Question question = operation_.draw(draws, families_[family]);
    if (engine_ != nullptr) question = fitted(operation_, question, engine_->declaration());
    if (options_.ordinary_only && range_of(question, options_.limits) == Range::extreme) {
      ++asked_[family].left_out, ++robust_[family].left_out;
      return;
    }
    if (engine_ != nullptr && !takes_alternative(operation_, question, engine_->declaration())) {
      ++asked_[family].other_alternative, ++robust_[family].other_alternative;
      return;
    }
    try {
      auto examination = operation_.examine(question);
      pending.push_back({family, index, std::move(question), std::move(examination)});
    } catch (const InvalidInput& refused) {
      asked_[family].refuse(refused.rule());
      robust_[family].refuse(refused.rule());
      const std::string mismatch = operation_.refusal_mismatch(question);
      if (!mismatch.empty()) {
        count(robust_[family], {operation_, question, "refused", index, options_.limits},
              {Verdict::invalid, 0, mismatch, 0});
      }
    }
  }

  const AuditOptions& options_;
  const Operation& operation_;
  const std::vector<std::size_t>& families_;
  Engine* engine_;
  const TimeLimit& limit_;
  const std::atomic<bool>& stop_;
  std::vector<Cell> asked_, robust_;
};

void require_an_operation(const Engine& engine, const AuditOptions& options) {
  const auto has = [&](const Operation* operation) { return engine.supports(operation->name()); };
  if (std::any_of(options.operations.begin(), options.operations.end(), has)) return;
  std::string asked;
  for (const Operation* operation : options.operations) {
    if (!operation->metadata().is_implementation()) asked += (asked.empty() ? "" : ", ") + operation->name();
  }
  throw EngineError("engine " + engine.declaration().engine + ": it declares none of the operations asked: " + asked);
}

/// The index of the first case that belongs to the shard after `shard`.
std::uint64_t bound(const AuditOptions& options, const Operation& operation, std::uint64_t shard) {
  const std::uint64_t cases = cases_of(operation, options.cases, options.by_cost);
  return static_cast<std::uint64_t>(static_cast<UInt128>(cases) * shard / options.shards);
}

bool has_counted(const Tally& tally, const Operation& operation) {
  return std::any_of(tally.operations.begin(), tally.operations.end(),
                     [&](const OperationTally& counted) { return counted.operation == operation.name(); });
}

std::vector<std::size_t> chosen_families(const Operation& operation, const std::vector<std::string>& names) {
  std::vector<std::size_t> chosen;
  const auto& all = operation.families();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (names.empty() || std::find(names.begin(), names.end(), all[i]) != names.end()) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace

Tally run_audit(const AuditOptions& options, const std::atomic<bool>& stop,
                const std::function<void(const std::string&, std::uint64_t)>& progress) {
  std::vector<std::unique_ptr<Engine>> engines(static_cast<std::size_t>(std::max(1, options.jobs)));
  if (options.engine) {
    for (auto& engine : engines) engine = options.engine();
  }
  if (options.engine) require_an_operation(*engines[0], options);
  Tally tally;
  tally.declaration = options.engine ? engines[0]->declaration() : reference_declaration();
  tally.seed = options.seed;
  tally.cases = options.cases;
  tally.by_cost = options.by_cost;
  tally.limits = options.limits;
  tally.grid.shards = options.shards;
  if (options.shards > 1) tally.grid.done = {options.shard};
  if (options.counted) tally.operations = options.counted->operations, tally.robust = options.counted->robust;
  for (const Operation* operation : options.operations) {
    const std::vector<std::size_t> families = chosen_families(*operation, options.families);
    if (families.empty() || (options.engine && operation->metadata().is_implementation())) continue;
    if (options.engine && !engines[0]->supports(operation->name())) {
      tally.undeclared.push_back(operation->name());
      continue;
    }
    if (has_counted(tally, *operation)) continue;
    const std::uint64_t first_case = bound(options, *operation, options.shard - 1),
                        last_case = bound(options, *operation, options.shard);
    const TimeLimit limit(options.seconds, options.clock);
    std::vector<Worker> workers;
    for (auto& engine : engines) {
      if (engine) engine->ask_until([&limit] { return limit.over(); });
      workers.emplace_back(options, *operation, families, engine.get(), limit, stop);
    }
    std::atomic<std::uint64_t> next{first_case};
    const std::uint64_t batch = options.seconds > 0 ? limited_batch_size : batch_size;
    in_parallel(options.jobs, workers.size(), [&](std::size_t w) {
      for (std::uint64_t first; !stop && (first = next.fetch_add(batch)) < last_case;) {
        if (limit.over()) break;
        try {
          workers[w].run_batch(first, std::min(first + batch, last_case));
        } catch (...) {
          next = last_case;  // the answers that the others would get are not needed
          throw;
        }
        progress(operation->name(), first - first_case);
      }
    });
    OperationTally asked{operation->name(), {}}, robust{operation->name(), {}};
    for (std::size_t f = 0; f < families.size(); ++f) {
      Cell of_asked, of_robust;
      for (const Worker& worker : workers) of_asked.merge(worker.asked()[f]), of_robust.merge(worker.robust()[f]);
      asked.families.emplace_back(operation->families()[families[f]], std::move(of_asked));
      robust.families.emplace_back(operation->families()[families[f]], std::move(of_robust));
    }
    Shrinking shrinking{
        *operation,       options.seed, options.limits, limit,
        engines[0].get(), false,        options.jobs,   effort_to_shrink(*operation, options.cases / options.shards)};
    if (options.smaller) shrinking.progress = [&](std::size_t i, std::size_t n) { options.smaller(*operation, i, n); };
    shrink_examples(shrinking, families, asked);
    shrinking.engine = nullptr, shrinking.robust = true;
    shrink_examples(shrinking, families, robust);
    for (auto& engine : engines) {
      if (engine) engine->ask_until(nullptr);
    }
    tally.operations.push_back(std::move(asked));
    tally.robust.push_back(std::move(robust));
    if (stop) break;
    if (options.after_operation) options.after_operation(tally);
  }
  tally.interrupted = stop;
  return tally;
}

}  // namespace touchstone::audit
