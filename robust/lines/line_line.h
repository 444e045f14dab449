// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/filters.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/line_line.h. Right, and every number correctly rounded, for all finite doubles in every
/// floating-point environment.
LineLine<double> line_line(const Line2d& a, const Line2d& b);

/// The decision alone; and which stage decided.
inline LineRelation line_line_relation(const Line2d& a, const Line2d& b);
inline LineRelation line_line_relation(const Line2d& a, const Line2d& b, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
inline std::optional<LineRelation> line_line_relation_filter(const Line2d& a, const Line2d& b);
std::optional<LineRelation> line_line_relation_lattice(const Line2d& a, const Line2d& b);
LineRelation line_line_relation_exact(const Line2d& a, const Line2d& b);
std::optional<LineLine<double>> line_line_lattice(const Line2d& a, const Line2d& b);
LineLine<double> line_line_exact(const Line2d& a, const Line2d& b);

/// Validation, then the stages after the filter.
LineRelation line_line_relation_past_filter(const Line2d& a, const Line2d& b, Stage& decided);

/// Knows only of lines that certainly cross.
inline std::optional<LineRelation> line_line_relation_filter(const Line2d& a, const Line2d& b) {
  if (filters::cross_sign(a.q - a.p, b.q - b.p) == filters::Sign::unknown) return std::nullopt;
  return LineRelation::crossing;
}

inline LineRelation line_line_relation(const Line2d& a, const Line2d& b, Stage& decided) {
  decided = Stage::filter;
  if (const auto answer = line_line_relation_filter(a, b)) return *answer;
  return line_line_relation_past_filter(a, b, decided);
}

inline LineRelation line_line_relation(const Line2d& a, const Line2d& b) {
  if (const auto answer = line_line_relation_filter(a, b)) return *answer;
  Stage ignored;
  return line_line_relation_past_filter(a, b, ignored);
}

}  // namespace touchstone::robust
