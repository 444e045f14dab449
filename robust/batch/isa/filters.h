// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "robust/batch/isa/eight_boxes.h"
#include "robust/kernel/filters/strict_math.h"

/// The filters of arrays, compiled once for each instruction set.
namespace touchstone::robust::batch::isa {

/// Rows of a chunk: each is one bit of a 64-bit number.
inline constexpr std::size_t chunk = 64;

/// The data that all rows share; empty if every operand is a column.
struct Shared {
  const double* numbers = nullptr;
  std::size_t count = 0;
};

/// The count of numbers of a face of a shared mesh, without and with the box around it (faces.h).
inline constexpr std::size_t of_face = 15, of_boxed_face = of_face + 5;
/// The count of numbers of a linear function in the plane and in space, and of their frame (linear_numbers.h).
inline constexpr std::size_t of_line = 3, of_plane = 4;
template <std::size_t dimensions>
inline constexpr std::size_t of_frame = 2 * dimensions + 1;

/// Filters `chunks` chunks: column k starts at columns[k], and its next chunk is steps[k] doubles further on (0: the
/// same chunk again). `answers` receives a byte for each row. `unknown` receives a number for each chunk, with the bits
/// of those rows that the filter could not decide; their bytes mean nothing.
using Filter = void(const double* const* columns, const std::size_t* steps, std::size_t chunks, const Shared& shared,
                    std::uint8_t* answers, std::uint64_t* unknown);

/// Decides the asked rows of one chunk, whose column k starts at columns[k]. Writes a byte for each row that it decides
/// and no others, and returns the rows that it does not decide.
using SecondStage = std::uint64_t(const double* const* columns, std::uint64_t asked, const Shared& shared,
                                  std::uint8_t* answers);

/// The filters of one instruction set. They hold if results are rounded to nearest and nothing is flushed.
struct Filters {
  Filter *orientation, *point_on_segment, *segment_segment, *point_plane;
  Filter *boxes_in_plane, *boxes_in_space, *spheres_in_plane, *spheres_in_space;
  Filter *sphere_and_box_in_plane, *sphere_and_box_in_space, *ray_and_box_in_plane, *ray_and_box_in_space;
  Filter *segment_triangle, *ray_triangle, *triangle_triangle;
  Filter *sphere_obb, *capsule_capsule, *obb_obb;
  Filter *point_in_ring, *point_in_convex_ring, *point_in_convex_solid, *point_in_solid;
  /// Second stages, for the rows that a filter left; nullptr if there is none.
  SecondStage *close_orientation, *close_point_on_segment, *close_segment_segment, *close_point_plane;
  SecondStage *close_boxes_in_plane, *close_boxes_in_space, *close_spheres_in_plane, *close_spheres_in_space;
  SecondStage *close_sphere_and_box_in_plane, *close_sphere_and_box_in_space;
  SecondStage *close_ray_and_box_in_plane, *close_ray_and_box_in_space;
  SecondStage *close_segment_triangle, *close_ray_triangle, *close_triangle_triangle;
  SecondStage *close_point_in_ring, *close_point_in_convex_solid, *close_point_in_solid, *none = nullptr;
  JoinPairs* join_pairs;  ///< holds in every environment in which doubles may be compared
};

extern const Filters portable_filters, avx2_filters, avx512_filters, neon_filters, sve_filters;

/// Returns the widest of these instruction sets that the processor has; nullptr if the control word asks for anything
/// but rounding to nearest and gradual underflow.
const Filters* filters_here(int at_most);

}  // namespace touchstone::robust::batch::isa
