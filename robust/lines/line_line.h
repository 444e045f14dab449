// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/filters.h"
#include "robust/kernel/staged.h"

namespace touchstone::robust {

/// Where two lines cross, each given by two points: `crossing` with the point and both parameters, in which a.p has 0
/// and a.q has 1; `parallel`; or `same`, where they have every point in common.
///
/// Right for all finite doubles in every floating-point environment, and every number correctly rounded. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so does a line with p == q ("two distinct
/// points"). Contract: reference/lines/line_line.h.
LineLine<double> line_line(const Line2d& a, const Line2d& b);

/// The decision alone, which costs less.
inline LineRelation line_line_relation(const Line2d& a, const Line2d& b);

namespace detail {

/// The filter knows only of lines that certainly cross.
struct line_line_relation : Filtered<line_line_relation, LineRelation> {
  static Perhaps<LineRelation> filter(const Line2d& a, const Line2d& b) {
    return filters::by_sign(filters::cross_sign(a.q - a.p, b.q - b.p), LineRelation::crossing, LineRelation::crossing);
  }
  static Decided<LineRelation> past_filter(const Line2d& a, const Line2d& b);
};

}  // namespace detail

inline LineRelation line_line_relation(const Line2d& a, const Line2d& b) {
  return detail::line_line_relation::ask(a, b).answer;
}

}  // namespace touchstone::robust
