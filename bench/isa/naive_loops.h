// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "robust/batch/isa/filters.h"

namespace touchstone::robust::batch::isa {

/// Computes answers of a plain formula over contiguous columns; the number of rows is a multiple of 64.
using NaiveLoop = void(const double* const* columns, std::size_t count, std::uint8_t* answers);
/// The same with one shape that all rows share: a ring's vertices, or the corners and a normal of each face of a solid.
using NaiveSharedLoop = void(const double* const* columns, const Shared& shape, std::size_t count,
                             std::uint8_t* answers);

struct NaiveLoops {
  NaiveLoop *orientation, *point_on_segment, *segment_segment, *point_plane;
  NaiveLoop *boxes_in_plane, *boxes_in_space, *spheres_in_plane, *spheres_in_space;
  NaiveLoop *sphere_and_box_in_plane, *sphere_and_box_in_space, *ray_and_box_in_plane, *ray_and_box_in_space;
  NaiveLoop *ray_triangle, *segment_triangle, *triangle_triangle;
  NaiveLoop *sphere_obb, *capsule_capsule, *obb_obb;
  NaiveSharedLoop *point_in_ring, *point_in_convex_ring, *point_in_convex_solid, *point_in_solid;
};

extern const NaiveLoops plain_loops, avx2_loops, avx512_loops;

/// Adds numbers: reads memory as fast as possible. The count is a multiple of 64.
double sum_of(const double* numbers, std::size_t count);

}  // namespace touchstone::robust::batch::isa
