// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/points.h"

// Shewchuk's predicates (Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997) as a
// peer, if Debian's libtet1.5-dev is installed (cmake/bench.cmake). They are in the public domain; the library around
// them, TetGen, is under the AGPL. Its header does not declare orient2d.
#ifdef TOUCHSTONE_BENCH_TET

void exactinit(int verbose, int no_exact, int no_filter, double max_x, double max_y, double max_z);
double orient2d(double* a, double* b, double* c);

namespace touchstone::bench {

/// Returns 1, 0, -1 if p lies left of, on, right of the line from p0 to p1. Right unless something overflows or
/// underflows.
inline int side_by_shewchuk(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  static const bool ready = (exactinit(0, 0, 1, 1, 1, 1), true);
  (void)ready;
  const auto at = [](const Point2d& point) { return const_cast<double*>(&point.x); };  // it writes nothing there
  const double turn = orient2d(at(p0), at(p1), at(p));
  return (turn > 0) - (turn < 0);
}

}  // namespace touchstone::bench

#endif
