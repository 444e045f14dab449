// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/flags.h"

#include <algorithm>
#include <cmath>

namespace touchstone::audit {

Verdict verdict_on_decision(const Judgement& judgement) {
  return judgement.verdict == Verdict::rounding && judgement.number ? Verdict::inexact : judgement.verdict;
}

namespace {

bool has_closed_ring(const Operation& operation, const Question& question) {
  struct {
    void number(const Shape&, const Cursor<double>&) {}
    void word(const Shape&, const Cursor<double>&) {}
  } pass;
  Cursor<double> at(question);
  for (const Shape::Part& part : operation.question_shape().parts) {
    const double* first = at.number;
    const bool plane = part.shape->name == "Polygon2<double>", space = part.shape->name == "Polygon3<double>";
    if (operation.question_shape().kind != Shape::Kind::record) return false;  // alternatives contain no polygon
    walk_encoded(*part.shape, at, pass);
    const std::ptrdiff_t axes = plane ? 2 : 3;
    if ((plane || space) && at.number - first > axes && std::equal(first, first + axes, at.number - axes)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> flags_of(const Operation& operation, const Question& question,
                                  const Examination& examination) {
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
  if (has_closed_ring(operation, question)) flags.emplace_back("closed_ring");
  return flags;
}

}  // namespace touchstone::audit
