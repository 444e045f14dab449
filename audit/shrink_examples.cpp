// SPDX-License-Identifier: Apache-2.0
#include "audit/shrink_examples.h"

#include <algorithm>
#include <map>

#include "audit/generic.h"
#include "audit/judged.h"
#include "audit/parallel.h"
#include "catalogue/codec/plain.h"
#include "catalogue/operation/fitted.h"
#include "catalogue/operation/shrink.h"

namespace touchstone::audit {
namespace {

/// What an engine may say while one finding is made smaller. Bytes, because the same run shall find the same whatever
/// the machine's speed; 300 answers of usual length are a tenth of it.
constexpr std::size_t most_read_to_shrink = 1 << 20;
constexpr std::size_t most_families = 4;

/// One example, and the draw streams around it.
class Shrinker {
 public:
  Shrinker(const Shrinking& shrinking, std::size_t family, const Way& way)
      : shrinking_(shrinking), family_(family), way_(way) {}

  /// `smaller`: otherwise the question stays as drawn and only its answer is added.
  void shrink(Finding& example, bool smaller) {
    if (shrinking_.limit.over() && shrinking_.engine != nullptr) return;  // what it answered is kept with the example
    DrawStream draws = case_draws(shrinking_.operation, family_, shrinking_.seed, example.index, true);
    shrinking_.operation.draw(draws, family_);
    const auto still_shown = [&](const std::vector<std::uint8_t>& candidate) {
      if (read_ >= most_read_to_shrink || shrinking_.limit.over()) return false;
      const std::optional<Finding> found = look(candidate, example.index);
      return found && found->range <= example.range && found->generic >= example.generic;
    };
    const std::vector<std::uint8_t> bytes = shrunk(draws.recorded(), still_shown, smaller ? budget() : 0);
    std::optional<Finding> least = look(bytes, example.index);
    // Only to have the answer to the question as it was drawn.
    if (!least || shown_before(example, *least)) least = look(draws.recorded(), example.index);
    if (least) example = *std::move(least);
  }

 private:
  int budget() const {
    const bool slow = way_.verdict == Verdict::invalid && shrinking_.engine != nullptr;
    return slow ? 20 : shrinking_.engine != nullptr ? 300 : 2000;
  }

  /// The question of these draws, where it is answered in the same way.
  std::optional<Finding> look(const std::vector<std::uint8_t>& bytes, std::uint64_t index) {
    const Operation& operation = shrinking_.operation;
    Engine* const engine = shrinking_.engine;
    DrawStream replay = DrawStream::replayed(bytes);
    Question question = operation.draw(replay, family_);
    if (engine != nullptr) question = fitted(operation, question, engine->declaration());
    Finding found{std::move(question), {}, nullptr, index};
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
      if (way_of(found.judgement, examination->outcome()) != way_) return std::nullopt;
      found.examined = std::make_shared<Once<std::unique_ptr<const Examination>>>(std::move(examination));
    } catch (const InvalidInput&) {
      return std::nullopt;
    }
    found.range = range_of(found.question, shrinking_.limits);
    found.generic = !found.judgement.degenerate && in_general_position(operation, found.question);
    return found;
  }

  const Shrinking& shrinking_;
  std::size_t family_;
  const Way& way_;
  std::size_t read_ = 0;
};

struct Task {
  const Way* way;
  Finding* example;
  std::size_t family;  ///< within the operation
  bool smaller = true;
};

}  // namespace

void shrink_examples(const Shrinking& shrinking, const std::vector<std::size_t>& families, OperationTally& tally) {
  std::map<Way, std::vector<Task>> by_way;
  for (std::size_t f = 0; f < families.size(); ++f) {
    for (auto& [way, counted] : tally.families[f].second.ways) {
      if (counted.example) by_way[way].push_back({&way, &*counted.example, families[f]});
    }
  }
  std::vector<Task> tasks;
  for (auto& [way, examples] : by_way) {
    std::stable_sort(examples.begin(), examples.end(),
                     [](const Task& a, const Task& b) { return shown_before(*a.example, *b.example); });
    for (std::size_t i = most_families; i < examples.size(); ++i) examples[i].smaller = false;
    tasks.insert(tasks.end(), examples.begin(), examples.end());
  }
  // One engine is asked one question after the other.
  in_parallel(shrinking.engine != nullptr ? 1 : shrinking.jobs, tasks.size(), [&](std::size_t t) {
    const auto& [way, example, family, smaller] = tasks[t];
    Shrinker(shrinking, family, *way).shrink(*example, smaller);
  });
}

}  // namespace touchstone::audit
