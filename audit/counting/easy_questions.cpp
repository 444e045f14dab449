// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/easy_questions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "audit/counting/judged.h"
#include "catalogue/operation/probes/fitted.h"
#include "catalogue/operation/probes/looks_outwards.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t wanted = 5;

/// True for multiples of 1/8 below 1,024: products of a few of them are exact in float, too.
bool is_short(double number) { return std::fabs(number) < 1024 && number * 8 == std::trunc(number * 8); }

bool is_easy(const Examination& examination, bool binary32) {
  if (examination.touch()) return false;
  if (examination.margin() && *examination.margin() < mpq_class(1, 8)) return false;
  return examination.judge_reference(binary32).verdict == Verdict::agree && !examination.inconclusive(binary32);
}

/// The sources of questions, used in this order until there are enough.
struct Source {
  std::uint64_t draws;  ///< of each family
  bool generic;         ///< only the family "random", with its numbers shortened: nothing is aligned
  bool only_short;
};
constexpr Source sources[] = {{400, true, true}, {60, false, true}, {60, false, false}};

/// Questions by their truth and their alternative (in the plane, in space).
class Examples {
 public:
  Examples(const Operation& operation, const Declaration& declaration)
      : operation_(operation), declaration_(declaration), alternatives_(operation.zeros_of_alternatives().size() > 1) {}

  bool enough() const { return count_ >= 2 * wanted; }
  std::size_t count() const { return count_; }

  void look(const Source& source) {
    for (std::uint64_t i = 0; i < source.draws && !enough(); ++i) {
      for (std::size_t family = 0; family < operation_.families().size(); ++family) {
        if (source.generic && operation_.families()[family] != "random") continue;
        DrawStream draws = case_draws(operation_, family, 1, i);
        Question question = operation_.draw(draws, family);
        for (double& number : question.numbers) {
          if (source.generic) number = std::rint(number * 64) / 4;  // drawn between -1 and 1
        }
        if (source.only_short && !std::all_of(question.numbers.begin(), question.numbers.end(), is_short)) continue;
        if (!takes_alternative(operation_, question, declaration_)) continue;
        if (looks_outwards(operation_, question)) add(fitted(operation_, question, declaration_));
      }
    }
  }

  /// Takes questions from every truth and alternative in turn.
  std::vector<EasyQuestion> chosen() {
    std::vector<EasyQuestion> all;
    for (std::size_t i = 0; i < wanted; ++i) {
      for (auto& [truth, alike] : by_truth_) {
        if (i < alike.size() && all.size() < wanted) all.push_back(std::move(alike[i]));
      }
    }
    return all;
  }

 private:
  void add(Question question) {
    if (!asked_.insert(one_line(operation_.print(question))).second) return;
    try {
      auto examination = operation_.examine(question);
      std::vector<EasyQuestion>& alike = by_truth_[{examination->outcome(), alternatives_ ? question.words[0] : 0}];
      if (alike.size() >= wanted || !is_easy(*examination, declaration_.binary32)) return;
      alike.push_back({std::move(question), std::move(examination)});
      ++count_;
    } catch (const InvalidInput&) {
    }
  }

  const Operation& operation_;
  const Declaration& declaration_;
  bool alternatives_;
  std::map<std::pair<std::string, Word>, std::vector<EasyQuestion>> by_truth_;  ///< and alternative
  std::set<std::string> asked_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<EasyQuestion> easy_questions(const Operation& operation, const Declaration& declaration) {
  Examples found(operation, declaration);
  for (const Source& source : sources) {
    if (found.count() < wanted) found.look(source);
  }
  return found.chosen();
}

}  // namespace touchstone::audit
