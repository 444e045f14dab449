// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/line_in_space.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// The first and the last t at which a valid line is in a valid box.
struct BoxPassage {
  /// Tests whether the entire line is on one side of the box on some axis: by comparisons and signs alone, which no
  /// rounding mode changes. A subnormal number may be read as zero, but never so that a false comparison becomes true.
  static Perhaps<Passage<double>> filter(const Line& line, const Box& box);
  /// The entry and the exit of each axis, each rounded correctly. Rounding is monotone: the latest entry, rounded, is
  /// the latest of the rounded entries, and if that is before the earliest exit or after it, so is the exact one.
  static Perhaps<Passage<double>> enclosed(const Line& line, const Box& box);
  static Passage<double> exact(const Line& line, const Box& box);
};

struct Clipped;
/// The passage of a line of which that part is in the solid; `moves`: it is not one point.
Passage<double> rounded_passage(const Clipped& part, bool moves);

/// Tests whether there is a passage: latest entry and earliest exit as fractions, each axis on a lattice of its own.
Perhaps<PassageRelation> box_relation_on_lattice(const Line& line, const Box& box);

}  // namespace touchstone::robust::kernel
