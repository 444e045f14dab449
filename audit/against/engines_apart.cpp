// SPDX-License-Identifier: Apache-2.0
#include "audit/against/engines_apart.h"

#include <algorithm>

#include "audit/counting/cases_of.h"
#include "audit/counting/judged.h"
#include "audit/logs/log_reader.h"
#include "audit/parallel.h"
#include "audit/reducing/reduced.h"
#include "catalogue/operation/probes/fitted.h"

namespace touchstone::audit {
namespace {

constexpr std::uint64_t asked_at_once = 256;

/// A question that both engines accept, and its origin.
struct Asking {
  Question question;
  std::string family;
  std::uint64_t index;
};

/// A recorded call about which the engine has not been asked yet.
struct Waiting {
  Asking asking;
  Reply recorded;
  Declaration declaration;
};

Question taken_by_both(const Operation& operation, const Question& question, const EnginePair& engines) {
  return fitted(operation, fitted(operation, question, engines.first->declaration()), engines.second->declaration());
}

bool answered_by_both(const Operation& operation, const Question& question, const EnginePair& engines) {
  return takes_alternative(operation, question, engines.first->declaration()) &&
         takes_alternative(operation, question, engines.second->declaration());
}

/// True if a question breaks the contract.
bool refused(const Operation& operation, const Question& question) {
  try {
    operation.row().robust(question, 0);
    return false;
  } catch (const InvalidInput&) {
    return true;
  }
}

/// Counts one question with both replies. Throws InvalidInput if the oracle refuses it.
void compare(PartedOperation& sum, const Operation& operation, const Asking& asking, const Reply& first,
             const Declaration& declared_first, const Reply& second, const Declaration& declared_second) {
  if (!first.asked || !second.asked) {
    ++sum.not_asked;
    return;
  }
  if (same_reply(operation, first, second)) {
    ++sum.asked;
    return;
  }
  const auto examination = operation.examine(asking.question);
  ++sum.asked;
  sum.add({asking.question, asking.family, asking.index, first.answer, second.answer,
           judged(first, *examination, declared_first), judged(second, *examination, declared_second)});
}

/// Accepts questions with the same two verdicts on different answers.
class StillApart final : public Interest {
 public:
  StillApart(const Operation& operation, std::vector<EnginePair>& engines, Parting& parting)
      : operation_(operation), engines_(engines), parting_(parting) {}

  Look look(std::size_t job, const Question& question) override {
    std::optional<Parting> found = apart(job, question);
    if (!found) return Look::fails;
    return Look::holds;
  }
  Question fitted(const Question& question) const override {
    return taken_by_both(operation_, question, engines_.front());
  }
  void go_on_with(const Question& question) override {
    if (std::optional<Parting> found = apart(0, question)) parting_ = *std::move(found);
  }

 private:
  std::optional<Parting> apart(std::size_t job, const Question& question) {
    EnginePair& pair = engines_[job % engines_.size()];
    const Reply first = pair.first->ask(operation_, {question})[0],
                second = pair.second->ask(operation_, {question})[0];
    PartedOperation found;
    try {
      compare(found, operation_, {question, parting_.family, parting_.index}, first, pair.first->declaration(), second,
              pair.second->declaration());
    } catch (const InvalidInput&) {
      return std::nullopt;
    }
    const auto kind = found.parted.find({parting_.of_first.verdict, parting_.of_second.verdict});
    return kind == found.parted.end() ? std::nullopt : kind->second.smallest;
  }

  const Operation& operation_;
  std::vector<EnginePair>& engines_;
  Parting& parting_;
};

void make_smaller(const Operation& operation, std::vector<EnginePair>& engines, const AgainstOptions& options,
                  const std::atomic<bool>& stop, PartedOperation& parted) {
  for (auto& [verdicts, kind] : parted.parted) {
    if (options.seconds_to_reduce <= 0 || stop || !kind.smallest) continue;
    StillApart apart(operation, engines, *kind.smallest);
    const Question question = kind.smallest->question;
    const SearchOptions search{options.jobs, TimeLimit(options.seconds_to_reduce), &stop, {}};
    apart.go_on_with(reduced(operation, question, apart, search).question);
  }
}

PartedOperation of_operation(const Operation& operation, std::vector<EnginePair>& engines,
                             const AgainstOptions& options, const std::atomic<bool>& stop) {
  const std::uint64_t cases = cases_of(operation, options.cases, options.by_cost);
  const std::size_t families = operation.families().size();
  std::vector<PartedOperation> sums(engines.size());
  std::atomic<std::uint64_t> next{0};
  in_parallel(options.jobs, engines.size(), [&](std::size_t job) {
    EnginePair& pair = engines[job];
    for (std::uint64_t begin; !stop && (begin = next.fetch_add(asked_at_once)) < cases;) {
      std::vector<Asking> askings;
      std::vector<Question> questions;
      for (std::uint64_t i = begin; i < std::min(begin + asked_at_once, cases); ++i) {
        DrawStream draws = case_draws(operation, i % families, options.seed, i / families);
        Question question = taken_by_both(operation, operation.draw(draws, i % families), pair);
        if (!answered_by_both(operation, question, pair) || refused(operation, question)) continue;
        questions.push_back(question);
        askings.push_back({std::move(question), operation.families()[i % families], i / families});
      }
      const std::vector<Reply> first = pair.first->ask(operation, questions),
                               second = pair.second->ask(operation, questions);
      for (std::size_t i = 0; i < askings.size(); ++i)
        compare(sums[job], operation, askings[i], first[i], pair.first->declaration(), second[i],
                pair.second->declaration());
      if (options.progress) options.progress(operation.name(), begin);
    }
  });
  PartedOperation sum;
  sum.operation = operation.name();
  for (PartedOperation& part : sums) sum.merge(std::move(part));
  make_smaller(operation, engines, options, stop, sum);
  return sum;
}

std::vector<EnginePair> pairs(const AgainstOptions& options) {
  std::vector<EnginePair> engines;
  for (int job = 0; job < std::max(1, options.jobs); ++job) engines.push_back(options.engines());
  return engines;
}

}  // namespace

std::uint64_t PartedOperation::count() const {
  std::uint64_t sum = 0;
  for (const auto& [verdicts, kind] : parted) sum += kind.count;
  return sum;
}

void PartedOperation::add(Parting parting) {
  Kind& kind = parted[{parting.of_first.verdict, parting.of_second.verdict}];
  ++kind.count;
  const auto before = [](const Parting& a, const Parting& b) {
    if (smaller(a.question, b.question) || smaller(b.question, a.question)) return smaller(a.question, b.question);
    return std::pair(a.family, a.index) < std::pair(b.family, b.index);
  };
  if (!kind.smallest || before(parting, *kind.smallest)) kind.smallest = std::move(parting);
}

void PartedOperation::merge(PartedOperation other) {
  asked += other.asked;
  not_asked += other.not_asked;
  for (auto& [verdicts, kind] : other.parted) {
    if (kind.smallest) add(*std::move(kind.smallest));
    parted[verdicts].count += kind.count - 1;
  }
}

bool same_reply(const Operation& operation, const Reply& a, const Reply& b) {
  if (a.kind != b.kind) return false;
  if (a.kind != Reply::Kind::answered || one_line(a.answer) == one_line(b.answer)) return true;
  // Fields may be in a different order, and numbers written differently.
  const auto as_read = [&](const Json& answer) {
    return one_line(answer_json(operation, recorded_answer(operation, answer)));
  };
  return as_read(a.answer) == as_read(b.answer);
}

std::vector<PartedOperation> ask_against(const AgainstOptions& options, const std::atomic<bool>& stop) {
  std::vector<EnginePair> engines = pairs(options);
  std::vector<PartedOperation> all;
  for (const Operation* operation : options.operations) {
    if (operation->metadata().is_implementation()) continue;
    if (!engines[0].first->supports(operation->name()) || !engines[0].second->supports(operation->name())) continue;
    all.push_back(of_operation(*operation, engines, options, stop));
    if (stop) break;
  }
  if (all.empty())
    throw EngineError("engines " + engines[0].first->declaration().engine + " and " +
                      engines[0].second->declaration().engine + ": no operation that both declare is asked");
  return all;
}

std::vector<PartedOperation> log_against(const std::vector<std::string>& files, const AgainstOptions& options,
                                         const std::atomic<bool>& stop) {
  std::vector<EnginePair> engines = pairs(options);
  Engine& engine = *engines[0].second;
  std::map<const Operation*, PartedOperation> sums;
  for (const std::string& file : files) {
    LogReader log(file);
    std::map<const Operation*, std::vector<Waiting>> waiting;
    const auto ask = [&](const Operation& operation, std::vector<Waiting>& calls) {
      std::vector<Question> questions;
      for (const Waiting& call : calls) questions.push_back(call.asking.question);
      const std::vector<Reply> replies = engine.ask(operation, questions);
      PartedOperation& sum = sums[&operation];
      sum.operation = operation.name();
      for (std::size_t i = 0; i < calls.size(); ++i)
        compare(sum, operation, calls[i].asking, calls[i].recorded, calls[i].declaration, replies[i],
                engine.declaration());
      calls.clear();
    };
    for (RecordedCall call; !stop && log.next(call);) {
      const Operation& operation = *call.operation;
      const bool asked =
          std::find(options.operations.begin(), options.operations.end(), &operation) != options.operations.end();
      if (!asked || !engine.supports(operation.name()) || refused(operation, call.question)) continue;
      auto& calls = waiting[&operation];
      Declaration declaration = log.header().declaration;
      declaration.binary32 = call.binary32;
      calls.push_back({{call.question, log.sites()[call.site], call.ordinal}, reply_of(call), declaration});
      if (calls.size() >= asked_at_once) ask(operation, calls);
    }
    for (auto& [operation, calls] : waiting) ask(*operation, calls);
  }
  std::vector<PartedOperation> all;
  for (const Operation* operation : all_operations())
    if (const auto found = sums.find(operation); found != sums.end()) all.push_back(std::move(found->second));
  return all;
}

}  // namespace touchstone::audit
