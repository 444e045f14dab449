// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "robust/batch/shapes/faces.h"

/// The linear functions of a point that robust/batch/isa/linear.h reads, one for each edge of a ring or face of a
/// solid, and their frame: the least corner o of the least box around the shape, its greatest corner, and the error of
/// all.
///
/// With the extents X, Y and Z of the box as computed, and v = 2^-53. Let p be a point in the box and a a vertex. As
/// rounding is monotone, no coordinate of p - o, of a - o, or of an edge exceeds the extent; each is off by v of
/// itself. Proved by machine, which counts less closely: 24 v X Y for an edge, 22 v T for a face
/// (robust/proofs/lane_linear.v).
///
/// The turn of an edge from a to b about p is A (p - o).x + B (p - o).y + C with A = a.y - b.y, B = b.x - a.x and C =
/// -A (a - o).x - B (a - o).y; no product of these exceeds X Y. In units of v X Y: C is off by 3 for each product, and
/// by 2 for its sum; the products of the value by 3 each, its sums by 3 and 4. That is 21 at most with FMA or without,
/// and C = 32 v pays for terms of higher order.
///
/// The volume of a face's corners and p is n . (p - o) - n . (a - o). For a coordinate of n let t be the sum of the
/// magnitudes of its two products: it is off by 4 v t. Let T be t . (X, Y, Z). In units of v T: the products of n . (a
/// - o) are off by 6, its sums by 2; the products of the value by 6, its sums by 2 each. That is 20 at most. C = 32 v.
///
/// Products that underflow are off by 2^-1075 each, in n times an extent; t and the error are 2^-1000 too large, which
/// pays for all. Nothing overflows where eight times X Y or T does not, and the error is infinite or NaN otherwise.
namespace touchstone::robust::batch::isa {

/// As it follows from a shape's size: X Y, or the greatest T.
inline double error_of_linear(double size) { return 8 * size * (4 * 0x1p-53) + 0x1p-1000; }

/// The least box around points of the input.
template <std::size_t dimensions>
struct LeastBox {
  double least[dimensions], most[dimensions];

  explicit LeastBox(const double* point) {
    std::copy_n(point, dimensions, least), std::copy_n(point, dimensions, most);
  }
  void add(const double* point) {
    for (std::size_t k = 0; k < dimensions; ++k) {
      least[k] = std::min(least[k], point[k]);
      most[k] = std::max(most[k], point[k]);
    }
  }
  double extent(std::size_t k) const { return most[k] - least[k]; }
  /// X Y, of edges in the plane of the axes k and k + 1.
  double size_of_lines(std::size_t k) const { return extent(k) * extent(k + 1); }
  /// T, of a face.
  double size_of_plane(const double* t) const { return t[0] * extent(0) + t[1] * extent(1) + t[2] * extent(2); }
  void add_frame(std::vector<double>& numbers, double size) const {
    numbers.insert(numbers.end(), least, least + dimensions), numbers.insert(numbers.end(), most, most + dimensions);
    numbers.push_back(error_of_linear(size));
  }
};

/// The function of the edge from a to b, whose coordinates are displaced by the least ones.
inline std::array<double, of_line> line_numbers(const double* a, const double* b, const double* least) {
  const double along_x = a[1] - b[1], along_y = b[0] - a[0];
  return {along_x, along_y, -(along_x * (a[0] - least[0])) - along_y * (a[1] - least[1])};
}

/// The function of a face's plane, from one of its corners and its normal.
inline std::array<double, of_plane> plane_function(const double* a, const double* n, const double* least) {
  const double constant = n[0] * (a[0] - least[0]) + n[1] * (a[1] - least[1]) + n[2] * (a[2] - least[2]);
  return {n[0], n[1], n[2], -constant};
}

/// The greater of two sizes; infinite if the second one is NaN.
inline double greater_size(double size, double other) {
  return std::max(size, std::min(std::numeric_limits<double>::infinity(), other));
}

/// Adds to a ring's vertices the frame, and the functions of its edges, each with its end.
inline void add_lines(std::vector<double>& numbers) {
  const std::size_t vertices = numbers.size();
  LeastBox<2> box(numbers.data());
  for (std::size_t k = 0; k < vertices; k += 2) box.add(&numbers[k]);
  numbers.reserve(vertices + of_frame<2> + of_line * vertices / 2);
  box.add_frame(numbers, box.size_of_lines(0));
  for (std::size_t k = 0; k < vertices; k += 2)
    for (const double number : line_numbers(&numbers[(k == 0 ? vertices : k) - 2], &numbers[k], box.least))
      numbers.push_back(number);
}

/// Adds to the numbers of faces, `step` each, the frame, and the functions of their planes. `projected`: before these
/// the error of the edges as seen along x, and before each face's plane their functions.
inline void add_planes(std::vector<double>& numbers, std::size_t step, bool projected) {
  const std::size_t faces = numbers.size();
  constexpr std::size_t corners[] = {0, 9, 12};
  LeastBox<3> box(numbers.data());
  double size = 0;
  for (std::size_t face = 0; face < faces; face += step)
    for (const std::size_t corner : corners) box.add(&numbers[face + corner]);
  for (std::size_t face = 0; face < faces; face += step)
    size = greater_size(size, box.size_of_plane(&numbers[face + 6]));
  numbers.reserve(faces + of_frame<3> + 1 + (3 * of_line + of_plane) * faces / step);
  box.add_frame(numbers, size);
  if (projected) numbers.push_back(error_of_linear(box.size_of_lines(1)));
  for (std::size_t face = 0; face < faces; face += step) {
    const double* const a = &numbers[face];
    for (std::size_t k = 0; k < 3 && projected; ++k)
      for (const double number : line_numbers(a + corners[k] + 1, a + corners[(k + 1) % 3] + 1, box.least + 1))
        numbers.push_back(number);
    for (const double number : plane_function(a, a + 3, box.least)) numbers.push_back(number);
  }
}

}  // namespace touchstone::robust::batch::isa
