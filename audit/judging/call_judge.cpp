// SPDX-License-Identifier: Apache-2.0
#include "audit/judging/call_judge.h"

#include <algorithm>
#include <bit>

#include "audit/counting/generic.h"
#include "audit/counting/judged.h"
#include "audit/judging/course.h"
#include "catalogue/codec/plain.h"
#include "catalogue/judge/compare.h"

namespace touchstone::audit {
namespace {

/// One of this many vouched-for calls is examined.
constexpr std::uint64_t spot_check = 4096;

const std::string yes_in_words = "true", no_in_words = "false";

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

/// True if an answer's words are enumerators, and flags that tell whether a number is present.
bool of_enumerators(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::number:
    case Shape::Kind::word: return true;
    case Shape::Kind::optional:
    case Shape::Kind::record:
      return std::all_of(shape.parts.begin(), shape.parts.end(),
                         [](const Shape::Part& part) { return of_enumerators(*part.shape); });
    default: return false;
  }
}

}  // namespace

CallJudge::CallJudge(Declaration declaration, const Limits& limits)
    : declaration_(std::move(declaration)), limits_(limits) {}

CallJudge::Reader& CallJudge::reader_of(const Operation& operation) {
  const auto [found, is_new] = readers_.try_emplace(&operation);
  if (is_new) {
    const bool covers = operation.metadata().kind == Kind::covering;
    found->second.decides = !operation.words().empty();
    found->second.by_words = !covers && found->second.decides && of_enumerators(operation.answer_shape());
  }
  return found->second;
}

const CallJudge::Outcome& CallJudge::outcome_of_words(const Operation& operation, std::deque<Outcome>& known,
                                                      const std::vector<Word>& words, bool partial) {
  constexpr std::size_t most_kept = 64;  // answers with lists are rarely alike
  for (const Outcome& outcome : known)
    if (outcome.words == words) return outcome;
  if (known.size() >= most_kept) known.pop_front();
  const Shape& shape = operation.answer_shape();
  return known.emplace_back(
      Outcome{words, outcome_of(shape, words, partial), partial ? std::nullopt : yes_or_no(shape, words)});
}

const std::string* CallJudge::same_answer(const RecordedCall& call, const EncodedValue<double>& robust,
                                          const Outcome& truth, Reader& reader) {
  const EncodedValue<double>& value = call.answer.value;
  switch (call.answer.kind) {
    case RecordedAnswer::Kind::plain:
      if (!truth.yes || *truth.yes != (value.words.at(0) != 0)) return nullptr;
      return *truth.yes ? &yes_in_words : &no_in_words;
    case RecordedAnswer::Kind::whole:
      return value.words == robust.words && same_bits(value.numbers, robust.numbers) ? &truth.name : nullptr;
    case RecordedAnswer::Kind::partial: {
      if (!reader.by_words || !value.numbers.empty()) return nullptr;
      const Outcome& said = outcome_of_words(*call.operation, reader.partial, value.words, true);
      return said.name == truth.name ? &said.name : nullptr;
    }
    default: return nullptr;
  }
}

void CallJudge::vouch(Site& site, const RecordedCall& call, const std::string& truth, const std::string& said) {
  const auto same = [&](const Vouched& known) { return known.truth == truth && known.said == said; };
  auto found = std::find_if(site.answers.begin(), site.answers.end(), same);
  if (found == site.answers.end()) {
    const std::string outcome = call.operation->name() + "/" + name_of(Verdict::agree) + "/" + truth + "/" + said;
    found = site.answers.insert(found, Vouched{truth, said, outcome});
  }
  const Range range = range_of(call.question, limits_);
  ++found->cases[static_cast<std::size_t>(range)];
  if (range == Range::ordinary && !has_direction_on_axis(*call.operation, call.question))
    for (Cell* const cell : {&site.counted.answers, &site.counted.robust}) ++cell->right_off_axis;
  found->hash += seed_of(call.ordinal, found->outcome.c_str(), 0);
}

std::string CallJudge::examine(Site& site, const RecordedCall& call) {
  const Operation& operation = *call.operation;
  const auto examination = operation.examine(call.question);
  const Asked asked{operation, call.question, examination->outcome(), call.ordinal, limits_};
  declaration_.binary32 = call.binary32;
  const JudgedReply said = judged_and_kept(reply_of(call), *examination, declaration_);
  count(site.counted.answers, asked, said.judgement, said.answer);
  const Judgement& robust = examination->judge_robust();
  count(site.counted.robust, asked, robust, is_shown(robust) ? examination->robust() : Json());
  site.counted.answers.recorded.as_open_sets += examination->touch();
  return asked.truth;
}

void CallJudge::judge(const RecordedCall& call) {
  const Operation& operation = *call.operation;
  const RowFunctions& row = operation.row();
  Site& site = sites_[{&operation, call.site}];
  ++(call.binary32 ? in_float_ : in_double_);
  try {
    const EncodedValue<double> robust = row.robust(call.question, 0);
    Reader& reader = reader_of(operation);
    const Outcome& of_robust = outcome_of_words(operation, reader.complete, robust.words, false);
    const Course course = course_of(call, call.binary32);
    // Rounding has neither changed the formula's course nor hidden a tie; the spread is a bound to first order.
    const bool sure = !course.in_doubt && course.nearest > 2;
    const std::string* const said = same_answer(call, robust, of_robust, reader);
    std::string truth = of_robust.name;
    if (said != nullptr && sure && call.ordinal % spot_check != 0) vouch(site, call, truth, *said);
    else truth = examine(site, call);
    Recorded& recorded = site.counted.answers.recorded;
    recorded.add_nearness(course.nearest);
    if (!reader.decides) return;
    const auto differs = [&](const std::vector<Word>& words) {
      return outcome_of_words(operation, reader.complete, words, false).name != truth;
    };
    const auto in = [&](bool binary32) {
      if (call.binary32 == binary32) return differs(course.words);
      return differs(binary32 ? course_of(call, true).words : row.reference(call.question).words);
    };
    recorded.in_double += in(false);
    recorded.in_float += in(true);
  } catch (const InvalidInput& refused) {
    site.counted.answers.refuse(refused.rule());
    site.counted.robust.refuse(refused.rule());
  }
}

void CallJudge::leave(const RecordedCall& call, const std::string& why) {
  Cell& answers = sites_[{call.operation, call.site}].counted.answers;
  ++answers.not_asked;
  answers.given_up = why;
}

std::map<std::pair<const Operation*, std::size_t>, CallJudge::Counted> CallJudge::take() {
  std::map<std::pair<const Operation*, std::size_t>, Counted> all;
  for (auto& [key, site] : sites_) {
    for (const Vouched& vouched : site.answers) {
      for (Cell* const cell : {&site.counted.answers, &site.counted.robust}) {
        const bool of_robust = cell == &site.counted.robust;
        OutcomeCount& counted =
            cell->outcomes[{Verdict::agree, vouched.truth, of_robust ? vouched.truth : vouched.said}];
        for (std::size_t r = 0; r < range_count; ++r) counted.cases[r] += vouched.cases[r];
        cell->hash += vouched.hash;
      }
    }
    all.emplace(key, std::move(site.counted));
  }
  sites_.clear();
  return all;
}

}  // namespace touchstone::audit
