// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "robust/kernel/strict_math.h"

/// Questions asked by the million, over columns: one array for each coordinate.
namespace touchstone::robust::batch {

/// Points of the plane, the i-th at (x[i], y[i]).
struct Points2 {
  const double* x;
  const double* y;
};

/// robust::orientation of each p0[i], p1[i], p[i] with i < count: its Side as a number, one byte each. Columns may
/// start anywhere. Refuses what orientation refuses, and says of the first such question which it is:
/// "questions[17].p1[0]".
void orientation(const Points2& p0, const Points2& p1, const Points2& p, std::size_t count, std::uint8_t* sides);

}  // namespace touchstone::robust::batch
