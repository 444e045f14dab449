// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds the point where two lines cross, each given by two points: `crossing` with the point and both parameters, in
/// which a.p has 0 and a.q has 1; `parallel`; or `same`, if they have every point in common.
///
/// Right for all finite doubles in every floating-point environment, and every number correctly rounded. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so does a line with p == q ("two distinct
/// points"). Contract: reference/lines/line_line.h.
LineLine<double> line_line(const Line2d& a, const Line2d& b);

/// The decision alone, which costs less.
inline LineRelation line_line_relation(const Line2d& a, const Line2d& b);

namespace stages {

struct line_line : Signatures<decltype(robust::line_line)> {
  static Partial enclosed, lattice;
  static Total exact;

  /// The filter decides only lines that certainly cross.
  struct decision : Filtered<decision, decltype(robust::line_line_relation)> {
    static Perhaps<LineRelation> filter(const Line2d& a, const Line2d& b) {
      return filters::by_sign(filters::cross_sign(a.q - a.p, b.q - b.p), LineRelation::crossing,
                              LineRelation::crossing);
    }
    static Partial lattice;
    static Total exact;
    static Staged past_filter;
  };
};

}  // namespace stages

inline LineRelation line_line_relation(const Line2d& a, const Line2d& b) {
  return stages::line_line::decision::ask(a, b).answer;
}

}  // namespace touchstone::robust
