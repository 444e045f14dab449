// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/line_in_space.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// The first and the last t at which a valid line is in a valid box.
struct BoxPassage {
  /// Whether on some axis all of the line is on one side of the box: comparisons and signs alone, which no rounding
  /// mode changes. A subnormal number may be read as zero, but never so that it becomes less than one that it is not
  /// less than.
  static Perhaps<Passage<double>> filter(const Line& line, const Box& box);
  /// The entry and the exit of each axis, each rounded correctly. Rounding is monotone: the latest of entries, rounded,
  /// is the latest of them rounded, and where that is before the earliest exit or after it, so is the exact one.
  static Perhaps<Passage<double>> enclosed(const Line& line, const Box& box);
  static Passage<double> exact(const Line& line, const Box& box);
};

/// Whether there is one: latest entry and earliest exit as fractions, each axis on a lattice of its own.
Perhaps<PassageRelation> box_relation_on_lattice(const Line& line, const Box& box);

}  // namespace touchstone::robust::kernel
