// SPDX-License-Identifier: Apache-2.0
// A unit for each instruction set includes this, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/beside.h"

/// The filter of points beside a closed mesh that all rows share.
namespace touchstone::robust::batch::isa {
namespace {

/// The edges of a face as seen along x, with the ray to +y from each point: y and z are what x and y are to
/// point_in_ring. Where an odd number of them is `crossed`, the point is within the face as seen, and `left` of the
/// edge that was, or right. `inconclusive`: a turn in doubt; `level`: a corner at the height of the point.
struct SeenAlongX {
  Mask crossed = 0, left = 0, inconclusive = 0, level = 0;

  void add(Lanes from_y, Lanes from_z, Lanes to_y, Lanes to_z, Mask higher, Mask to_higher) {
    const TurnSeen turn(from_y, from_z, to_y, to_z);
    const Verdict right = by_sign(turn.value, turn.bound);
    const Mask crosses = higher ^ to_higher, counted = crosses & (right.set ^ to_higher);
    inconclusive |= crosses & ~right.known;
    crossed ^= counted;
    left |= counted & ~right.set;
  }
};

/// The ray to +x from each point, with all faces of a closed mesh: shared.numbers holds those of shared.count faces
/// and of the boxes around them, least y, greatest y, least z, greatest z, greatest x.
///
/// A point that is on no face is inside where the ray crosses an odd number of faces, each counted where the point is
/// within it as seen along x and the plane is ahead: it turns the other way about the point than its edges do. An edge
/// of two faces is crossed for both or for neither, by the same comparisons. On a face the point is within it as seen,
/// and its side of the plane in doubt; or on an edge as seen, whose turn is then 0 or one of whose ends is as high; so
/// what is decided here is off the boundary. What a face whose box is elsewhere adds is 0.
void point_in_solid(const double* const* columns, const std::size_t* steps, std::size_t chunks, const Shared& shared,
                    std::uint8_t* answers, std::uint64_t* unknown) {
  for (std::size_t n = 0; n < chunks; ++n) {
    std::uint64_t known = 0, outside = 0;
    for (std::size_t i = 0; i < chunk; i += lanes) {
      Lanes p[3];
      Mask finite = all_lanes, odd = 0, open = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = Lanes::at(columns[k] + n * steps[k] + i);
        finite &= not_below(same(0x1.fffffffffffffp1023), magnitude(p[k]));
      }
      for (std::size_t face = 0; face < shared.count; ++face) {
        const double *const numbers = shared.numbers + of_boxed_face * face, *const box = numbers + of_face;
        const Mask beside = above(same(box[0]), p[1]) | above(p[1], same(box[1])) | above(same(box[2]), p[2]) |
                            above(p[2], same(box[3])) | above(p[0], same(box[4]));
        const Mask near = finite & ~beside;
        if (near == 0) continue;
        Lanes y[3], z[3];
        Mask higher[3];
        SeenAlongX seen;
        for (std::size_t k = 0; k < 3; ++k) {
          const double* const corner = numbers + (k == 0 ? 0 : 6 + 3 * k);
          y[k] = same(corner[1]) - p[1], z[k] = same(corner[2]) - p[2];
          higher[k] = above(z[k], same(0));
          seen.level |= equal(z[k], same(0));
        }
        for (std::size_t k = 0; k < 3; ++k)
          seen.add(y[k], z[k], y[(k + 1) % 3], z[(k + 1) % 3], higher[k], higher[(k + 1) % 3]);
        const Certain side = side_of_face(numbers, p);
        const Mask within = near & seen.crossed;
        odd ^= within & ((seen.left & side.negative) | (~seen.left & side.positive));
        open |= near & (seen.inconclusive | seen.level | (seen.crossed & ~(side.positive | side.negative)));
      }
      known |= static_cast<std::uint64_t>(finite & ~open) << i;
      outside |= static_cast<std::uint64_t>(~odd & all_lanes) << i;
    }
    unknown[n] = ~known;
    put_locations(answers + n * chunk, outside, 0);
  }
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
