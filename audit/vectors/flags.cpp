// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/flags.h"

#include <cmath>

namespace touchstone::audit {

Verdict verdict_on_decision(const Judgement& judgement) {
  return judgement.verdict == Verdict::rounding && judgement.number ? Verdict::inexact : judgement.verdict;
}

std::vector<std::string> flags_of(const Question& question, const Examination& examination) {
  std::vector<std::string> flags;
  if (examination.touch()) flags.emplace_back("touch");
  if (examination.margin() && sgn(*examination.margin()) == 0) flags.emplace_back("degenerate");
  switch (verdict_on_decision(examination.judge_reference())) {
    case Verdict::rounding: flags.emplace_back("formula_rounds"); break;
    case Verdict::algorithm: flags.emplace_back("formula_wrong"); break;
    case Verdict::inexact:
    case Verdict::invalid: flags.emplace_back("formula_inexact"); break;
    default: break;
  }
  for (const double number : question.numbers) {
    const double size = std::fabs(number);
    if (size > 0x1p500 || (size > 0 && size < 0x1p-1022)) {
      flags.emplace_back("extreme");
      break;
    }
  }
  return flags;
}

}  // namespace touchstone::audit
