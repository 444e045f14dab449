// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/invalid_input.h"
#include "robust/batch/isa/limits.h"

/// Decisions over columns of millions of rows.
///
/// robust::batch::NAME(operands..., count, answers) writes robust::NAME of row i of the operands to answers[i], for
/// every i < count: the enumerator as a number, one byte each. Like those of robust::NAME, the answers are right for
/// all finite doubles in every floating-point environment; they are the same with every instruction set.
///
/// Rows that robust::NAME refuses are refused: InvalidInput names the first such row and its field,
/// "questions[17].p1[0]". Some answers may have been written by then. A row count of 0 asks nothing, and refuses
/// nothing.
///
/// Several threads may call at the same time, and one call may use several threads (`Limits`). Nothing is allocated
/// unless a row needs integers of arbitrary length or threads are used, and nothing is kept between calls.
namespace touchstone::robust::batch {

/// One number of each row, that of row i at data[i * stride]. The stride is 1 for an array of its own, 2 or 3 for
/// interleaved points, as in an array of the shape (n, 2) or (n, 3), and 0 for one operand that all rows share. May
/// start at any double.
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
struct Capsules3 {
  Segments3 segment;
  Column radius;
};
struct HalfAxes3 {
  Vectors3 u, v, w;
};
struct Obbs3 {
  Points3 center;
  HalfAxes3 half_axes;
};

}  // namespace touchstone::robust::batch
