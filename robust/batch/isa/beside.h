// SPDX-License-Identifier: Apache-2.0
// A unit for each instruction set includes this, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/close_triangles.h"

/// Filters of points beside a shape that all rows share: the model and the constants of kernels.h. Where an instruction
/// set has an FMA, the edges and faces that a filter cannot tell are looked at again, exactly. The turn of an edge and
/// the side of a face, with the numbers that a face has, are proved by machine from their text
/// (robust/proofs/lane_beside.v); what is concluded from all of them is argued here.
namespace touchstone::robust::batch::isa {
namespace {

/// On which side of a face a point is; positive is where its normal points to. Its numbers are a corner a, the normal
/// n, t, the sums of the magnitudes of n's terms, and the other corners, counter-clockwise as seen from there
/// (robust/batch/isa/faces.h).
///
/// As for FacePlane of robust/kernel/face_filter.h: a product of n . (p - a) goes through eight roundings, the last of
/// which cannot make a sign wrong, so a value of the wrong sign is at most 7 v times the sum of the magnitudes of the
/// six products of three differences. C = 8 v. t is at least the magnitude of n, coordinate by coordinate, and the
/// terms are summed in the order of the value: where a partial sum of the value overflows, so does that of the terms. A
/// product in n that underflows is off by h, and by h times a coordinate of p - a in the value: t is 2^-1000 too large,
/// and C 2^-1000 pays for that.
[[gnu::always_inline]] inline Certain side_of_face(const double* numbers, const Lanes* p) {
  Lanes value = same(0), terms = value;
  for (std::size_t k = 0; k < 3; ++k) {
    const Lanes d = p[k] - same(numbers[k]);
    const Lanes product = same(numbers[3 + k]) * d, term = same(numbers[6 + k]) * magnitude(d);
    value = k == 0 ? product : value + product;
    terms = k == 0 ? term : terms + term;
  }
  const Lanes bound = multiply_add(terms, same(8 * v), same(tiny));
  return {above(value, bound), above(same(0) - value, bound)};
}

/// On which side of a point's line an edge is, once more; `open`: still not known.
struct Closer {
  Mask right = 0, on = 0, open = 0;
};

#if TOUCHSTONE_LANES > 2

/// `inconclusive`: points that the filter knows nothing of; `level`: points with the y of the edge's end.
[[gnu::noinline]] Closer closer_to_edge(const double* from, const double* to, Lanes x, Lanes y, Mask inconclusive,
                                        Mask level) {
  const Lanes a[] = {same(from[0]), same(from[1])}, b[] = {same(to[0]), same(to[1])}, p[] = {x, y};
  Sides turn = close_turn({b[0], a[0]}, {b[1], a[1]}, {y, a[1]}, {x, a[0]});
  settle(turn, a, b, p, inconclusive);
  const Mask between = equal(a[1], y) & (above(a[0], x) ^ above(b[0], x));
  return {turn.right, (inconclusive & turn.on) | (level & (equal(b[0], x) | between)), inconclusive & ~turn.known()};
}

/// On which side of a face points in the window of cubes are, exactly.
Signs exact_side_of_face(const double* numbers, const Lanes* point, Mask asked) {
  Lanes at[9];
  for (std::size_t k = 0; k < 9; ++k) at[k] = same(numbers[k < 3 ? k : 6 + k]);
  const InSpace a(at), b(at + 3), c(at + 6);
  const Mask valid = asked & in_window_of_cubes<9>(at);
  return CloseNormal(Way(b, a), Way(c, a)).along(Way(InSpace(point), a), valid).of(valid);
}

/// Where points are of which the filter knows of no face that they are outside: outside of one, on one, inside.
[[gnu::noinline]] Signs closer_to_faces(const Shared& shared, const Lanes* point, Mask open) {
  Signs found{0, open & in_window_of_cubes<3>(point), 0};
  for (std::size_t face = 0; face < shared.count && found.known() != 0; ++face) {
    const double* const numbers = shared.numbers + of_face * face;
    const Mask asked = found.negative | found.zero;
    const Certain likely = side_of_face(numbers, point);
    Signs side{likely.positive, likely.negative, 0};
    if ((asked & ~side.known()) != 0) side = exact_side_of_face(numbers, point, asked);
    found.positive |= asked & side.positive;
    found.zero |= found.negative & side.zero;
    found.negative &= side.negative;
    found.zero &= side.negative | side.zero;
  }
  return found;
}

#else

Closer closer_to_edge(const double*, const double*, Lanes, Lanes, Mask inconclusive, Mask level) {
  return {0, 0, inconclusive | level};
}
Signs closer_to_faces(const Shared&, const Lanes*, Mask) { return {}; }

#endif

/// A byte for each point of a chunk: inside 0, on the boundary 1, outside 2.
void put_locations(std::uint8_t* to, std::uint64_t outside, std::uint64_t boundary) {
  put_bytes(to, outside, 2, 0);
  for (; boundary != 0; boundary &= boundary - 1) to[__builtin_ctzll(boundary)] = 1;
}

/// The turn of a point and the ends of an edge, of which these are the differences from the point: as Turn, with its C.
struct TurnSeen {
  Lanes value, bound;
  TurnSeen(Lanes from_x, Lanes from_y, Lanes to_x, Lanes to_y) {
    const Lanes l = from_x * to_y, r = from_y * to_x;
    value = l - r;
    bound = multiply_add(magnitude(l + r), same(4 * v), same(tiny));
  }
};

/// The ray to +x from each point, with all edges of a ring: shared.numbers holds its vertices, x and y in turn, which
/// are finite; there are shared.count of them.
///
/// An edge from a to b crosses the ray's line where exactly one of a.y and b.y is greater than the point's y; those are
/// comparisons, and exact. It crosses the ray where the turn of a, b and the point has the sign of b.y - a.y: as for
/// Turn, and where it is in doubt, the edge is looked at closer. On the boundary the point is on an edge that crosses
/// the line, where the turn is 0; or on a horizontal one or a vertex, and then it has the y of a vertex.
void point_in_ring(const double* const* columns, const std::size_t* steps, std::size_t chunks, const Shared& shared,
                   std::uint8_t* answers, std::uint64_t* unknown) {
  const double* const last = shared.numbers + 2 * (shared.count - 1);
  for (std::size_t n = 0; n < chunks; ++n) {
    std::uint64_t known = 0, outside = 0, boundary = 0;
    for (std::size_t i = 0; i < chunk; i += lanes) {
      const Lanes x = Lanes::at(columns[0] + n * steps[0] + i), y = Lanes::at(columns[1] + n * steps[1] + i);
      Lanes from_x = same(last[0]) - x, from_y = same(last[1]) - y;
      Mask higher = above(same(last[1]), y), open = 0, odd = 0, on = 0;
      const double* a = last;
      for (const double* b = shared.numbers; b != last + 2; a = b, b += 2) {
        const Lanes by = same(b[1]), to_x = same(b[0]) - x, to_y = by - y;
        const Mask b_higher = above(by, y), crosses = higher ^ b_higher, level = equal(by, y);
        const TurnSeen seen(from_x, from_y, to_x, to_y);
        const Verdict turn = by_sign(seen.value, seen.bound);
        const Mask inconclusive = crosses & ~turn.known;
        Mask right = turn.set;
        if ((inconclusive | level) != 0) [[unlikely]] {
          const Closer found = closer_to_edge(a, b, x, y, inconclusive, level);
          on |= found.on, open |= found.open;
          right = (right & ~inconclusive) | (found.right & inconclusive);
        }
        odd ^= crosses & (right ^ b_higher);
        from_x = to_x, from_y = to_y, higher = b_higher;
      }
      const Mask finite =
          not_below(same(0x1.fffffffffffffp1023), magnitude(x)) & not_below(same(0x1.fffffffffffffp1023), magnitude(y));
      known |= static_cast<std::uint64_t>(finite & (on | ~open) & all_lanes) << i;
      outside |= static_cast<std::uint64_t>(~odd & all_lanes) << i;
      boundary |= static_cast<std::uint64_t>(on & all_lanes) << i;
    }
    unknown[n] = ~known;
    put_locations(answers + n * chunk, outside, boundary);
  }
}

/// The side of every face of a convex solid on which each point lies: outside of one, on one, or inside of all.
/// shared.numbers holds the numbers of shared.count faces.
void point_in_convex_solid(const double* const* columns, const std::size_t* steps, std::size_t chunks,
                           const Shared& shared, std::uint8_t* answers, std::uint64_t* unknown) {
  for (std::size_t n = 0; n < chunks; ++n) {
    std::uint64_t known = 0, outside = 0, boundary = 0;
    for (std::size_t i = 0; i < chunk; i += lanes) {
      Lanes p[3];
      for (std::size_t k = 0; k < 3; ++k) p[k] = Lanes::at(columns[k] + n * steps[k] + i);
      Mask out = 0, in = all_lanes;
      for (std::size_t face = 0; face < shared.count && out != all_lanes; ++face) {
        const Certain side = side_of_face(shared.numbers + of_face * face, p);
        out |= side.positive, in &= side.negative;
      }
      Mask on = 0;
      if (const Mask open = all_lanes & ~(out | in); open != 0) [[unlikely]] {
        const Signs found = closer_to_faces(shared, p, open);
        out |= found.positive, in |= found.negative | found.zero, on = found.zero;
      }
      known |= static_cast<std::uint64_t>(out | in) << i;
      outside |= static_cast<std::uint64_t>(out) << i;
      boundary |= static_cast<std::uint64_t>(on) << i;
    }
    unknown[n] = ~known;
    put_locations(answers + n * chunk, outside, boundary);
  }
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
