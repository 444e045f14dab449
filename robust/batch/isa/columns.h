// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/invalid_input.h"
#include "robust/kernel/filters/strict_math.h"

/// Decisions asked by the million, over columns.
///
/// robust::batch::NAME(operands..., count, answers) writes to answers[i] what robust::NAME answers of row i of the
/// operands, for every i < count: the enumerator as a number, a byte each. The answers are right for all finite doubles
/// in every floating-point environment, as those of robust::NAME are, and the same with every instruction set.
///
/// What robust::NAME refuses is refused: InvalidInput names the first such row and its field, "questions[17].p1[0]". Of
/// the answers some may have been written then. A row count of 0 asks nothing, and refuses nothing.
///
/// Several threads may call at the same time. Nothing is allocated unless a row has to be decided with integers of any
/// length, and nothing is kept between calls.
namespace touchstone::robust::batch {

/// One number of each row, that of row i at data[i * stride]: 1 for an array of its own, 2 or 3 for points side by
/// side, as in an array of the shape (n, 2) or (n, 3), 0 for one operand that all rows share. May start at any double.
struct Column {
  const double* data = nullptr;
  std::ptrdiff_t stride = 1;

  Column() = default;
  Column(const double* data, std::ptrdiff_t stride = 1) : data(data), stride(stride) {}
};

struct Points2 {
  Column x, y;
};
struct Points3 {
  Column x, y, z;
};
struct Vectors2 {
  Column x, y;
};
struct Vectors3 {
  Column x, y, z;
};
struct Segments2 {
  Points2 a, b;
};
struct Segments3 {
  Points3 a, b;
};
struct Boxes2 {
  Points2 min, max;
};
struct Boxes3 {
  Points3 min, max;
};
struct Spheres2 {
  Points2 center;
  Column radius;
};
struct Spheres3 {
  Points3 center;
  Column radius;
};
struct Planes {
  Vectors3 normal;
  Column offset;
};
struct Rays2 {
  Points2 origin;
  Vectors2 direction;
};
struct Rays3 {
  Points3 origin;
  Vectors3 direction;
};
struct Triangles3 {
  Points3 a, b, c;
};

/// Which instructions a call may use. It uses the widest of these that the processor has; the answers are the same.
enum class Instructions { portable, avx2, avx512 };

}  // namespace touchstone::robust::batch
