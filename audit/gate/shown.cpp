// SPDX-License-Identifier: Apache-2.0
#include "audit/gate/shown.h"

#include <algorithm>

#include "audit/counted.h"
#include "audit/counting/repeat.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/plain.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t most_shown = 2000;

}  // namespace

const char* cause_in_words(Cause cause) {
  switch (cause) {
    case Cause::cancellation: return "wrong by rounding: sums cancel";
    case Cause::out_of_range: return "wrong by rounding: overflow or underflow";
    case Cause::algorithm: return "wrong, and rounding is not to blame";
    case Cause::inexact: return "a number further off than the stated bound, as rounding explains";
    case Cause::invalid: return "no valid answer: NaN, infinity, exception, crash, or none in time";
    case Cause::convention: return "a touch answered as open sets do";
    case Cause::tolerance: return "wrong decision within the declared tolerance";
    case Cause::unsupported: return "not answered";
    case Cause::not_asked: return "not asked: the engine was given up";
    case Cause::surplus: return "more listed beyond the truth than --max-surplus allows";
    case Cause::inconsistent_convention: return "touches answered now as closed sets do, now as open sets do";
  }
  return "";
}

std::string in_words(const GateEntry& entry) {
  const Found& found = entry.found;
  if (found.family.empty())
    return std::string(name_of(found.cause)) + ": " + cause_in_words(found.cause) + (entry.known > 0 ? ", known" : "");
  return std::string(name_of(found.cause)) + " in " + grouped(found.findings) + " of " + counted(found.cases, "case") +
         (entry.known > 0 ? ", known: " + grouped(entry.known) : "");
}

const Finding* example_of(const Tally& tally, const Found& found) {
  const Finding* best = nullptr;
  const auto fits = [&](const Finding& finding) {
    return cause_of(finding.judgement) == std::string(name_of(found.cause));
  };
  const auto before = [&](const Finding& a, const Finding& b) {
    return fits(a) != fits(b) ? fits(a) : shown_before(a, b);
  };
  for (const OperationTally& operation : tally.operations) {
    if (operation.operation != found.operation) continue;
    for (const auto& [family, cell] : operation.families) {
      if (family != found.family) continue;
      for (const auto& [outcome, counted] : cell.outcomes) {
        const bool of_rounding = found.cause == Cause::cancellation || found.cause == Cause::out_of_range;
        const std::string verdict = of_rounding ? "rounding" : name_of(found.cause);
        if (name_of(outcome.verdict) != verdict || !counted.example) continue;
        if (best == nullptr || before(*counted.example, *best)) best = &*counted.example;
      }
    }
  }
  return best;
}

std::string described(const Tally& tally, const std::string& operation_name, const Finding& finding, bool of_robust) {
  const Operation* operation = find_operation(operation_name);
  if (!operation) return "";
  const auto line = [](const std::string& key, const std::string& value) {
    return key + excerpt(value, most_shown) + "\n";
  };
  std::string text = (finding.vector.empty() ? "" : line("vector: ", finding.vector)) +
                     line("input:  ", one_line(operation->print(finding.question))) +
                     line("hex:    ", one_line(operation->print_hexadecimal(finding.question)));
  try {
    text += line("truth:  ", one_line(finding.examination(*operation).truth()));
  } catch (const InvalidInput& refused) {
    text += line("truth:  ", std::string("refused: ") + refused.what());
  }
  text += line("answer: ", finding.answer.is_null() ? no_answer : one_line(plain(finding.answer)));
  if (!finding.judgement.remark.empty()) text += line("remark: ", finding.judgement.remark);
  return text + "repeat: " + repeat_command(*operation, finding.question, tally, of_robust) + "\n";
}

}  // namespace touchstone::audit
