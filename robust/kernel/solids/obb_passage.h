// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/line_in_space.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// The first and the last t at which a valid line is in a valid oriented box: it is what lies between three pairs of
/// planes, each spanned by two half axes.
struct ObbPassage {
  /// The entry and the exit of each pair, each rounded correctly, as in BoxPassage. Numbers are `moderate`.
  static Perhaps<Passage<double>> enclosed(const Line& line, const Obb3d& obb);
  static Passage<double> exact(const Line& line, const Obb3d& obb);
};

}  // namespace touchstone::robust::kernel
