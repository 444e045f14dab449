// SPDX-License-Identifier: Apache-2.0
// A unit for each instruction set includes this, with TOUCHSTONE_LANES of its own.
#pragma once

#include "bench/isa/naive_loops.h"
#include "bench/isa/naive_solids.h"
#include "bench/isa/naive_space.h"
#include "robust/batch/isa/lanes.h"

/// The formulas that one writes if rounding does not matter, in the lanes of robust/batch: the baseline for exact
/// answers. With one lane they are a plain loop.
namespace touchstone::robust::batch::isa {
namespace {

struct NaiveOrientation {
  static constexpr std::size_t columns = 6;
  static constexpr std::uint8_t set = 2, clear = 0;
  static Mask of(const Lanes* c) { return negative((c[2] - c[0]) * (c[5] - c[1]) - (c[3] - c[1]) * (c[4] - c[0])); }
};

/// On the line, and in the segment's box.
struct NaivePointOnSegment {
  static constexpr std::size_t columns = 6;
  static constexpr std::uint8_t set = 0, clear = 1;
  static Mask of(const Lanes* c) {
    const Lanes x = c[0], y = c[1];
    const Mask on_line = equal((c[4] - c[2]) * (y - c[3]) - (c[5] - c[3]) * (x - c[2]), same(0));
    return on_line & not_below(x, lesser(c[2], c[4])) & not_below(greater(c[2], c[4]), x) &
           not_below(y, lesser(c[3], c[5])) & not_below(greater(c[3], c[5]), y);
  }
};

/// Four sides; reports that segments on one line meet.
struct NaiveSegmentSegment {
  static constexpr std::size_t columns = 8;
  static constexpr std::uint8_t set = 0, clear = 1;
  static Mask of(const Lanes* c) {
    const Lanes ax = c[0], ay = c[1], bx = c[2], by = c[3], px = c[4], py = c[5], qx = c[6], qy = c[7];
    const auto turn = [](Lanes ox, Lanes oy, Lanes ex, Lanes ey, Lanes x, Lanes y) {
      return (ex - ox) * (y - oy) - (ey - oy) * (x - ox);
    };
    const Lanes first = turn(ax, ay, bx, by, px, py) * turn(ax, ay, bx, by, qx, qy);
    const Lanes second = turn(px, py, qx, qy, ax, ay) * turn(px, py, qx, qy, bx, by);
    return above(greater(first, second), same(0));
  }
};

struct NaivePointPlane {
  static constexpr std::size_t columns = 7;
  static constexpr std::uint8_t set = 2, clear = 0;
  static Mask of(const Lanes* c) { return negative(c[0] * c[4] + c[1] * c[5] + c[2] * c[6] + c[3]); }
};

template <std::size_t n>
struct NaiveBoxes {
  static constexpr std::size_t columns = 4 * n;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask of(const Lanes* c) {
    Mask apart = 0;
    for (std::size_t k = 0; k < n; ++k) apart |= above(c[k], c[3 * n + k]) | above(c[2 * n + k], c[n + k]);
    return apart;
  }
};

template <std::size_t n>
struct NaiveSpheres {
  static constexpr std::size_t columns = 2 * n + 2;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask of(const Lanes* c) {
    Lanes distance = same(0);
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes way = c[n + 1 + k] - c[k];
      distance = k == 0 ? way * way : distance + way * way;
    }
    const Lanes reach = c[n] + c[2 * n + 1];
    return above(distance, reach * reach);
  }
};

template <std::size_t n>
struct NaiveSphereBox {
  static constexpr std::size_t columns = 3 * n + 1;
  static constexpr std::uint8_t set = 0, clear = 2;
  static Mask of(const Lanes* c) {
    Lanes distance = same(0);
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes way = c[k] - lesser(greater(c[k], c[n + 1 + k]), c[2 * n + 1 + k]);
      distance = k == 0 ? way * way : distance + way * way;
    }
    return above(distance, c[n] * c[n]);
  }
};

/// Slabs.
template <std::size_t n>
struct NaiveRayBox {
  static constexpr std::size_t columns = 4 * n;
  static constexpr std::uint8_t set = 1, clear = 0;
  static Mask of(const Lanes* c) {
    Lanes first = same(0), last = same(__builtin_inf());
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes inverse = same(1) / c[n + k];
      const Lanes s = (c[2 * n + k] - c[k]) * inverse, t = (c[3 * n + k] - c[k]) * inverse;
      first = greater(lesser(s, t), first);
      last = lesser(greater(s, t), last);
    }
    return not_below(last, first);
  }
};

template <class F>
void naive_beside(const double* const* columns, const Shared& shape, std::size_t count, std::uint8_t* answers) {
  for (std::size_t first = 0; first < count; first += chunk) {
    std::uint64_t set = 0;
    for (std::size_t i = 0; i < chunk; i += lanes) {
      Lanes numbers[F::columns];
      for (std::size_t k = 0; k < F::columns; ++k) numbers[k] = Lanes::at(columns[k] + first + i);
      Mask found = 0;
      if constexpr (requires { F::of(numbers); }) found = F::of(numbers);
      else found = F::of(numbers, shape);
      if (lanes == 1) answers[first + i] = found != 0 ? F::set : F::clear;
      else set |= static_cast<std::uint64_t>(found) << i;
    }
    if (lanes != 1) put_bytes(answers + first, set, F::set, F::clear);
  }
}
template <class F>
void naive(const double* const* columns, std::size_t count, std::uint8_t* answers) {
  naive_beside<F>(columns, Shared{}, count, answers);
}

constexpr NaiveLoops loops_of_this_unit{.orientation = naive<NaiveOrientation>,
                                        .point_on_segment = naive<NaivePointOnSegment>,
                                        .segment_segment = naive<NaiveSegmentSegment>,
                                        .point_plane = naive<NaivePointPlane>,
                                        .boxes_in_plane = naive<NaiveBoxes<2>>,
                                        .boxes_in_space = naive<NaiveBoxes<3>>,
                                        .spheres_in_plane = naive<NaiveSpheres<2>>,
                                        .spheres_in_space = naive<NaiveSpheres<3>>,
                                        .sphere_and_box_in_plane = naive<NaiveSphereBox<2>>,
                                        .sphere_and_box_in_space = naive<NaiveSphereBox<3>>,
                                        .ray_and_box_in_plane = naive<NaiveRayBox<2>>,
                                        .ray_and_box_in_space = naive<NaiveRayBox<3>>,
                                        .ray_triangle = naive<NaiveRayTriangle>,
                                        .segment_triangle = naive<NaiveSegmentTriangle>,
                                        .triangle_triangle = naive<NaiveTriangles>,
                                        .sphere_obb = naive<NaiveSphereObb>,
                                        .capsule_capsule = naive<NaiveCapsules>,
                                        .obb_obb = naive<NaiveObbs>,
                                        .point_in_ring = naive_beside<NaiveRing>,
                                        .point_in_convex_ring = naive_beside<NaiveConvexRing>,
                                        .point_in_convex_solid = naive_beside<NaiveConvexSolid>,
                                        .point_in_solid = naive_beside<NaiveSolid>};

}  // namespace
}  // namespace touchstone::robust::batch::isa
