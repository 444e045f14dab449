// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/shrink_examples.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <numeric>
#include <set>

#include "audit/counting/generic.h"
#include "audit/counting/judged.h"
#include "audit/parallel.h"
#include "catalogue/codec/plain.h"
#include "catalogue/operation/probes/fitted.h"
#include "catalogue/operation/probes/shrink.h"

namespace touchstone::audit {
namespace {

/// A limit on the engine's output while one finding is shrunk. In bytes, because the same run must find the same
/// whatever the machine's speed; 300 answers of usual length are a tenth of it.
constexpr std::size_t most_read_to_shrink = 1 << 20;
constexpr std::size_t most_families = 4;
/// In units of Metadata::cost. Half a second per operation if 2,000 cases of it are asked; the most expensive ones get
/// a little in any case.
constexpr std::uint64_t effort_of_a_case = 5, least_solves = 100;

/// The amount of computation for a question, judging by its length.
std::uint64_t numbers_in(const Question& question) { return 1 + question.numbers.size() + question.words.size(); }

/// One example, and the draw streams around it.
class Shrinker {
 public:
  Shrinker(const Shrinking& shrinking, std::size_t family, const JudgedOutcome& outcome, Finding& example)
      : shrinking_(shrinking), family_(family), outcome_(outcome), example_(example) {}

  const Finding& example() const { return example_; }
  bool ended() const { return ended_; }

  /// Continues from the current state until nothing smaller is found, or the effort is spent; returns the effort spent.
  /// `smaller`: if false, the question stays as drawn, and is only examined.
  std::uint64_t shrink(std::uint64_t effort, std::uint64_t usual_length, bool smaller) {
    ended_ = true;
    if (shrinking_.limit.over()) return 0;
    effort_ = effort, usual_length_ = usual_length, spent_ = 0;
    if (!begun_) begin();
    if (!smaller) return spent_;
    draws_ = shrunk(
        draws_, [&](const auto& candidate) { return still_shown(candidate); }, most_solves_);
    if (ended_) refused_.clear();
    return spent_;
  }

 private:
  void begin() {
    begun_ = true;
    DrawStream draws = case_draws(shrinking_.operation, family_, shrinking_.seed, example_.index, true);
    shrinking_.operation.draw(draws, family_);
    draws_ = draws.recorded();
    const bool slow = outcome_.verdict == Verdict::invalid && shrinking_.engine != nullptr;
    most_solves_ = slow ? 20 : shrinking_.engine != nullptr ? 300 : 2000;
    if (std::optional<Finding> drawn = look(draws_)) example_ = *std::move(drawn);
  }

  bool still_shown(const std::vector<std::uint8_t>& candidate) {
    if (read_ >= most_read_to_shrink || shrinking_.limit.over() || refused_.count(candidate) > 0) return false;
    if (spent_ >= effort_) {
      ended_ = false;
      return false;
    }
    --most_solves_;
    std::optional<Finding> found = look(candidate);
    if (!found || found->range > example_.range || found->features > example_.features) {
      refused_.insert(candidate);
      return false;
    }
    if (!shown_before(example_, *found)) example_ = *std::move(found);
    return true;
  }

  /// The question of these draws, if it has the same outcome.
  std::optional<Finding> look(const std::vector<std::uint8_t>& bytes) {
    const Operation& operation = shrinking_.operation;
    Engine* const engine = shrinking_.engine;
    DrawStream replay = DrawStream::replayed(bytes);
    Question question = operation.draw(replay, family_);
    if (engine != nullptr) question = fitted(operation, question, engine->declaration());
    spent_ += std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(operation.metadata().cost) * numbers_in(question) / usual_length_);
    Finding found{std::move(question), {}, nullptr, example_.index};
    try {
      std::unique_ptr<const Examination> examination = operation.examine(found.question);
      if (shrinking_.robust) {
        found.judgement = examination->judge_robust();
        found.answer = examination->robust();
      } else if (engine == nullptr) {
        found.judgement = examination->judge_reference();
        found.answer = examination->reference();
      } else {
        const Reply reply = engine->ask(operation, {found.question})[0];
        read_ += reply.bytes;
        if (!reply.asked) return std::nullopt;
        found.judgement = judged(reply, *examination, engine->declaration());
        found.answer = kept(reply.answer);
      }
      if (judged_outcome(found.judgement, examination->outcome()) != outcome_) return std::nullopt;
      found.examined = std::make_shared<Once<std::unique_ptr<const Examination>>>(std::move(examination));
    } catch (const InvalidInput&) {
      return std::nullopt;
    }
    found.range = range_of(found.question, shrinking_.limits);
    found.features = degenerate_features(operation, found.question, found.judgement.degenerate);
    return found;
  }

  const Shrinking& shrinking_;
  std::size_t family_;
  const JudgedOutcome& outcome_;
  Finding& example_;
  std::vector<std::uint8_t> draws_{};
  std::set<std::vector<std::uint8_t>> refused_{};  ///< not asked again when shrinking continues
  int most_solves_ = 0;
  std::uint64_t effort_ = 0, spent_ = 0, usual_length_ = 1;
  std::size_t read_ = 0;
  bool begun_ = false, ended_ = false;
};

/// Examples in the order in which they are shrunk: first the one of each outcome that is shown, then those of its next
/// families.
struct Waves {
  std::vector<Shrinker> shown, others, rest;
};

Waves waves_of(const Shrinking& shrinking, const std::vector<std::size_t>& families, OperationTally& tally) {
  std::map<JudgedOutcome, std::vector<Shrinker>> by_outcome;
  for (std::size_t f = 0; f < families.size(); ++f) {
    for (auto& [outcome, counted] : tally.families[f].second.outcomes)
      if (counted.example) by_outcome[outcome].emplace_back(shrinking, families[f], outcome, *counted.example);
  }
  Waves waves;
  for (auto& [outcome, examples] : by_outcome) {
    // Sorts indices, because a shrinker refers to its example and must not move.
    std::vector<std::size_t> order(examples.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&, &all = examples](std::size_t a, std::size_t b) {
      return shown_before(all[a].example(), all[b].example());
    });
    for (std::size_t i = 0; i < order.size(); ++i)
      (i == 0 ? waves.shown : i < most_families ? waves.others : waves.rest).push_back(examples[order[i]]);
  }
  return waves;
}

std::uint64_t mean_length(const Waves& waves) {
  std::uint64_t sum = 0, n = 0;
  for (const auto* wave : {&waves.shown, &waves.others, &waves.rest})
    for (const Shrinker& one : *wave) sum += numbers_in(one.example().question), ++n;
  return n > 0 ? sum / n : 1;
}

}  // namespace

std::uint64_t effort_to_shrink(const Operation& operation, std::uint64_t cases) {
  return std::max(least_solves * static_cast<std::uint64_t>(operation.metadata().cost), effort_of_a_case * cases);
}

void shrink_examples(const Shrinking& shrinking, const std::vector<std::size_t>& families, OperationTally& tally) {
  Waves waves = waves_of(shrinking, families, tally);
  const std::uint64_t usual_length = mean_length(waves);
  const std::size_t all = waves.shown.size() + waves.others.size();
  const auto cost = static_cast<std::uint64_t>(shrinking.operation.metadata().cost);
  std::uint64_t left = shrinking.effort;
  std::atomic<std::size_t> done{0};
  // A single engine is asked one question after the other.
  const int jobs = shrinking.engine != nullptr ? 1 : shrinking.jobs;
  for (auto* wave : {&waves.shown, &waves.others, &waves.rest}) {
    const bool smaller = wave != &waves.rest;
    std::vector<Shrinker*> open;
    for (std::size_t i = 0; i < wave->size() && (i + 1) * cost <= left; ++i) open.push_back(&(*wave)[i]);
    // Unused shares go to examples that had too little. The shares are the same on every machine.
    for (bool first = true; !open.empty() && left >= open.size() * cost; first = false) {
      const std::uint64_t share = left / open.size();
      std::vector<std::uint64_t> spent(open.size());
      in_parallel(jobs, open.size(), [&](std::size_t i) {
        if (first && smaller && shrinking.progress) shrinking.progress(++done, all);
        spent[i] = open[i]->shrink(share, usual_length, smaller);
      });
      left -= std::min(left, std::accumulate(spent.begin(), spent.end(), std::uint64_t{0}));
      std::erase_if(open, [](const Shrinker* one) { return one->ended(); });
    }
  }
}

}  // namespace touchstone::audit
