// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/solid.h"

/// Points against a shape that all rows share, by one linear function for each of its edges or faces: of the point's
/// displacement from the least corner of the least box around the shape (robust/batch/shapes/linear_numbers.h). A value
/// that exceeds the error, which is the same for all, has the sign of the exact one. A point outside of the box is
/// outside of the shape, by comparisons.
///
/// Proved by machine from this text: that this holds for each edge and face (robust/proofs/lane_linear_sides.v); what a
/// filter that is sure says of all of them (lane_rings.v, lane_solids.v); that a point is in the hull of a convex ring,
/// or not, and not in that of a convex solid (lane_hulls.v); whether the ray meets an odd number of a solid's faces
/// (lane_rays.v).
namespace touchstone::robust::batch::isa {
namespace {

/// The value of a linear function, whose numbers are its coefficients and its constant.
template <std::size_t dimensions>
Lanes linear(const double* numbers, const Lanes* d) {
  Lanes value = same(numbers[dimensions]);
  for (std::size_t k = dimensions; k-- > 0;) value = multiply_add(same(numbers[k]), d[k], value);
  return value;
}

/// Points as the linear functions see them.
template <std::size_t dimensions>
struct Framed {
  Framed(const double* frame, const Lanes* p) : error(same(frame[2 * dimensions])) {
    for (std::size_t k = 0; k < dimensions; ++k) {
      const Lanes least = same(frame[k]);
      d[k] = p[k] - least;
      beyond |= above(least, p[k]) | above(p[k], same(frame[dimensions + k]));
    }
  }

  Lanes at(const double* numbers) const { return linear<dimensions>(numbers, d); }

  /// Knows the points p that are beyond the box, and the others that are sure.
  Located located(const Lanes* p, Mask sure, Mask outside) const {
    return {finite<dimensions>(p) & (beyond | sure), beyond | outside, 0};
  }

  Lanes d[dimensions], error;
  Mask beyond = 0;
};

/// The sign bits of numbers; other bits mean nothing.
class SignBits {
 public:
  explicit SignBits(Lanes x) { std::memcpy(&bits_, &x.v, sizeof bits_); }
  friend SignBits operator^(SignBits x, SignBits y) { return SignBits(x.bits_ ^ y.bits_); }
  friend SignBits operator&(SignBits x, SignBits y) { return SignBits(x.bits_ & y.bits_); }
  friend SignBits operator|(SignBits x, SignBits y) { return SignBits(x.bits_ | y.bits_); }
  friend SignBits operator~(SignBits x) { return SignBits(~x.bits_); }
  Mask set() const {
    Lanes x;
    std::memcpy(&x.v, &bits_, sizeof bits_);
    return negative(x);
  }

 private:
#if TOUCHSTONE_LANES > 1
  __extension__ typedef std::int64_t Bits __attribute__((vector_size(8 * TOUCHSTONE_LANES)));
#else
  typedef std::int64_t Bits;
#endif
  explicit SignBits(Bits bits) : bits_(bits) {}
  Bits bits_;
};

/// Casts the ray to +x from each point against all edges of a ring: the frame and the functions of its edges follow the
/// numbers that Ring reads.
///
/// An edge from a to b crosses the ray's line if exactly one of a.y and b.y is less than the point's y. It crosses the
/// ray if its turn about the point has the sign of b.y - a.y. A point on an edge, or on the line of one, has a turn
/// that is 0, and is left to the other stages.
struct RingByLines : Ring {
  static Located filtered(const Shared& shared, const Lanes* p) {
    const std::size_t vertices = 2 * shared.count;
    const Framed<2> point(shared.numbers + vertices, p);
    const double* line = shared.numbers + vertices + of_frame<2>;
    Lanes least = same(0x1.fffffffffffffp1023);
    SignBits odd(same(0)), from_y(same(shared.numbers[vertices - 1]) - p[1]);
    for (std::size_t vertex = 0; vertex < shared.count; ++vertex, line += of_line) {
      const Lanes turn = point.at(line);
      const SignBits to_y(same(shared.numbers[2 * vertex + 1]) - p[1]);
      odd = odd ^ ((from_y ^ to_y) & ~(SignBits(turn) ^ to_y));
      least = lesser(least, magnitude(turn));
      from_y = to_y;
    }
    return point.located(p, above(least, point.error), ~odd.set());
  }
};

/// The sides of all edges of a convex ring on which each point lies: inside if they are all the same.
struct ConvexRingByLines : Ring {
  static Located filtered(const Shared& shared, const Lanes* p) {
    const std::size_t vertices = 2 * shared.count;
    const Framed<2> point(shared.numbers + vertices, p);
    const double* line = shared.numbers + vertices + of_frame<2>;
    Lanes least = point.at(line), greatest = least;
    for (std::size_t vertex = 1; vertex < shared.count; ++vertex) {
      const Lanes turn = point.at(line += of_line);
      least = lesser(least, turn), greatest = greater(greatest, turn);
    }
    const Lanes error = point.error, other = same(0) - error;
    const Mask left = above(greatest, error), right = above(other, least);
    return point.located(p, (left & right) | above(least, error) | above(other, greatest), left & right);
  }
};

/// The sides of all faces of a convex solid on which each point lies: inside if it is behind all. The frame and the
/// functions of the faces follow the numbers that ConvexSolid reads.
struct ConvexSolidByPlanes : ConvexSolid {
  static Located filtered(const Shared& shared, const Lanes* p) {
    const Framed<3> point(shared.numbers + of_face * shared.count, p);
    const double* plane = shared.numbers + of_face * shared.count + of_frame<3>;
    Lanes greatest = point.at(plane);
    for (std::size_t face = 1; face < shared.count; ++face) greatest = greater(greatest, point.at(plane += of_plane));
    const Mask outside = above(greatest, point.error);
    return point.located(p, outside | above(same(0) - point.error, greatest), outside);
  }
};

/// Casts the ray to +x from each point, as Solid does: the frame, the error of projected edges, and the functions of
/// each face's projected edges and plane follow the numbers that Solid reads. A point on a face is within its
/// projection and in its plane; or it is on the line of a projected edge, and then its turn is 0. A point near such a
/// line counts no face whose box does not hold it, and is left to the other stages by the others.
struct SolidByPlanes : Solid {
  static Located filtered(const Shared& shared, const Lanes* p) {
    const double* face = shared.numbers;
    const double* functions = face + of_boxed_face * shared.count;
    const Framed<3> point(functions, p);
    const Lanes error_of_turns = same(functions[of_frame<3>]);
    functions += of_frame<3> + 1;
    Mask odd = 0, open = 0;
    for (std::size_t n = 0; n < shared.count; ++n, face += of_boxed_face, functions += 3 * of_line + of_plane) {
      const SignBits lower[] = {below(face[2], p), below(face[11], p), below(face[14], p)};
      SignBits crossed(same(0)), left = crossed;
      Lanes least = same(0x1.fffffffffffffp1023);
      for (std::size_t k = 0; k < 3; ++k) {
        const Lanes turn = linear<2>(functions + of_line * k, point.d + 1);
        const SignBits right(turn), to = lower[(k + 1) % 3], counted = (lower[k] ^ to) & ~(right ^ to);
        crossed = crossed ^ counted, left = left | (counted & ~right);
        least = lesser(least, magnitude(turn));
      }
      const Lanes side = point.at(functions + 3 * of_line);
      const Mask close = ~above(least, error_of_turns) & all_lanes;
      odd ^= (crossed & ~(left ^ SignBits(side))).set() & ~close;
      open |= crossed.set() & ~above(magnitude(side), point.error);
      if (close == 0) continue;
      open |= close & ~beside(face + of_face, p);
    }
    return point.located(p, ~open, ~odd);
  }

 private:
  static SignBits below(double z, const Lanes* p) { return SignBits(same(z) - p[2]); }
};

}  // namespace
}  // namespace touchstone::robust::batch::isa
