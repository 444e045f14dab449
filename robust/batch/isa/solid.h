// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/beside.h"

/// The filter of points against a closed mesh that all rows share.
namespace touchstone::robust::batch::isa {
namespace {

/// The edges of a face as seen along x, with the ray to +y from each point: y and z play the role that x and y play in
/// Ring. If an odd number of them is `crossed`, the projected face contains the point, which lies `left` of the crossed
/// edge, or right. `inconclusive`: a turn is uncertain; `level`: a corner has the point's height.
struct SeenAlongX {
  Mask crossed = 0, left = 0, inconclusive = 0, level = 0;

  SeenAlongX(const double* numbers, const Lanes* p) {
    Lanes y[3], z[3];
    Mask higher[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const double* const corner = numbers + (k == 0 ? 0 : 6 + 3 * k);
      y[k] = same(corner[1]) - p[1], z[k] = same(corner[2]) - p[2];
      higher[k] = above(z[k], same(0));
      level |= equal(z[k], same(0));
    }
    for (std::size_t k = 0; k < 3; ++k) add(y[k], z[k], y[(k + 1) % 3], z[(k + 1) % 3], higher[k], higher[(k + 1) % 3]);
  }

 private:
  void add(Lanes from_y, Lanes from_z, Lanes to_y, Lanes to_z, Mask higher, Mask to_higher) {
    const TurnSeen turn(from_y, from_z, to_y, to_z);
    const Verdict right = by_sign(turn.value, turn.bound);
    const Mask crosses = higher ^ to_higher, counted = crosses & (right.set ^ to_higher);
    inconclusive |= crosses & ~right.known;
    crossed ^= counted;
    left |= counted & ~right.set;
  }
};

/// Casts the ray to +x from each point against all faces of a closed mesh: shared.numbers holds those of shared.count
/// faces and of the boxes around them, least y, greatest y, least z, greatest z, greatest x.
///
/// A point that is on no face is inside if the ray crosses an odd number of faces. A face counts if its projection
/// along x contains the point and its plane is ahead: its turn about the point is opposite to that of its edges. An
/// edge of two faces is crossed for both or for neither, by the same comparisons. A point on a face is within its
/// projection and in its plane, which is tested exactly; or it is on a projected edge, whose turn is then 0 or one of
/// whose ends has the same height, and that is not decided here. A face whose box does not match adds 0.
class Solid {
 public:
  static constexpr std::size_t columns = 3;

#ifdef TOUCHSTONE_SECOND_STAGE
  static Located closely(const Shared& shared, const Lanes* p) {
    Mask odd = 0, on = 0, open = ~finite<columns>(p), left = 0;
    Waiting waiting;
    const auto look = [&] {
      const Signs side = exact_side({shared.numbers, of_boxed_face, waiting.part}, p, waiting.asked);
      odd ^= ahead(left, side.positive, side.negative);
      on |= side.zero, open |= waiting.asked & ~side.known();
      waiting.asked = 0;
    };
    for (std::size_t face = 0; face < shared.count; ++face) {
      const double* const numbers = shared.numbers + of_boxed_face * face;
      const Mask near = ~(open | beside(numbers + of_face, p)) & all_lanes;
      if (near == 0) continue;
      const SeenAlongX seen(numbers, p);
      const Certain side = side_of_face(numbers, p);
      open |= near & (seen.inconclusive | seen.level);
      const Mask within = near & seen.crossed & ~open, inconclusive = within & ~side.known();
      odd ^= within & ahead(seen.left, side.positive, side.negative);
      if (!waiting.has_room(inconclusive)) look();
      waiting.add(inconclusive, face);
      left = (left & ~inconclusive) | (seen.left & inconclusive);
    }
    look();
    return {on | ~open, ~odd, on};
  }
#endif

 protected:
  /// The points for which the plane of a face lies ahead, from their side of it and that of the crossed edge.
  static Mask ahead(Mask left, Mask positive, Mask negative) { return (left & negative) | (~left & positive); }

  static Mask beside(const double* box, const Lanes* p) {
    return above(same(box[0]), p[1]) | above(p[1], same(box[1])) | above(same(box[2]), p[2]) |
           above(p[2], same(box[3])) | above(p[0], same(box[4]));
  }
};

}  // namespace
}  // namespace touchstone::robust::batch::isa
