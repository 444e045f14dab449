// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/line_line.h. Right, and every number correctly rounded, for all finite doubles in every
/// floating-point environment.
LineLine<double> line_line(const Line2d& a, const Line2d& b);

/// The decision alone; and which stage decided.
inline LineRelation line_line_relation(const Line2d& a, const Line2d& b);
inline LineRelation line_line_relation(const Line2d& a, const Line2d& b, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
std::optional<LineRelation> line_line_relation_lattice(const Line2d& a, const Line2d& b);
LineRelation line_line_relation_exact(const Line2d& a, const Line2d& b);
std::optional<LineLine<double>> line_line_lattice(const Line2d& a, const Line2d& b);
LineLine<double> line_line_exact(const Line2d& a, const Line2d& b);

/// The door, then the stages after the filter.
LineRelation line_line_relation_past_filter(const Line2d& a, const Line2d& b, Stage& decided);

inline LineRelation line_line_relation(const Line2d& a, const Line2d& b, Stage& decided) {
  return line_line_relation_past_filter(a, b, decided);
}

inline LineRelation line_line_relation(const Line2d& a, const Line2d& b) {
  Stage ignored;
  return line_line_relation_past_filter(a, b, ignored);
}

}  // namespace touchstone::robust
