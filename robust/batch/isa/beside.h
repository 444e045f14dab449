// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/close_triangles.h"

/// Points against a shape that all rows share: the model and the constants of kernels.h. A filter decides a point if it
/// is certain about every edge or face that matters. For instruction sets with an FMA, the second stage decides the
/// others exactly. The turn of an edge and the side of a face, computed from a face's numbers, are proved by machine
/// from their text (robust/proofs/lane_beside.v); the conclusions from all edges and faces are argued here.
namespace touchstone::robust::batch::isa {
namespace {

/// The lanes whose value is certainly positive, and certainly negative.
struct Certain {
  Mask positive, negative;
  Mask known() const { return positive | negative; }
};

/// The side of a face on which a point lies; positive is the side to which the normal points. Its numbers are a corner
/// a, the normal n, t, the sums of the magnitudes of n's terms, and the other corners, counter-clockwise as seen from
/// there (robust/batch/shapes/faces.h).
///
/// As for FacePlane of robust/kernel/filters/face_filter.h: a product of n . (p - a) goes through eight roundings, the
/// last of which cannot make a sign wrong, so a value of the wrong sign is at most 7 v times the sum of the magnitudes
/// of the six products of three differences. C = 8 v. t is at least the magnitude of n, coordinate by coordinate, and
/// the terms are summed in the order of the value: where a partial sum of the value overflows, so does that of the
/// terms. A product in n that underflows is off by h, and by h times a coordinate of p - a in the value: t is 2^-1000
/// too large, and C 2^-1000 pays for that.
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

/// The points whose location is certain; among these, those outside and those on the boundary.
struct Located {
  Mask known, outside, on;
};

/// The points whose numbers are all finite.
template <std::size_t dimensions>
Mask finite(const Lanes* p) {
  Mask all = all_lanes;
  for (std::size_t k = 0; k < dimensions; ++k) all &= not_below(same(0x1.fffffffffffffp1023), magnitude(p[k]));
  return all;
}

#ifdef TOUCHSTONE_SECOND_STAGE

/// Parts of a shape that a filter cannot decide, at most one for each lane, so that all lanes are examined at once.
struct Waiting {
  Mask asked = 0;
  Lanes part = same(0);  ///< its number
  bool has_room(Mask inconclusive) const { return (asked & inconclusive) == 0; }
  void add(Mask inconclusive, std::size_t number) {
    part = chosen(inconclusive, same(static_cast<double>(number)), part);
    asked |= inconclusive;
  }
};

/// Gathers the numbers of a part for each lane.
class Gathered {
 public:
  Gathered(const double* numbers, std::size_t of_part, Lanes part) {
    double number[lanes];
    std::memcpy(number, &part.v, sizeof number);
    for (std::size_t i = 0; i < lanes; ++i) from_[i] = numbers + of_part * static_cast<std::size_t>(number[i]);
  }
  Lanes operator[](std::size_t k) const {
    double of_each[lanes];
    for (std::size_t i = 0; i < lanes; ++i) of_each[i] = from_[i][k];
    return Lanes::at(of_each);
  }

 private:
  const double* from_[lanes];
};

/// The sides of faces on which points lie, exact if all numbers are in the window of cubes.
[[gnu::noinline]] Signs exact_side(const Gathered& face, const Lanes* point, Mask asked) {
  Lanes at[9];
  for (std::size_t k = 0; k < 9; ++k) at[k] = face[k < 3 ? k : 6 + k];
  const InSpace a(at), b(at + 3), c(at + 6);
  const Mask valid = asked & in_window_of_cubes<9>(at) & in_window_of_cubes<3>(point);
  return CloseNormal(Way(b, a), Way(c, a)).along(Way(InSpace(point), a), valid).of(valid);
}

#endif

/// The turn at a point of an edge whose ends are given by their differences from the point: as Turn, with its C.
struct TurnSeen {
  Lanes value, bound;
  TurnSeen(Lanes from_x, Lanes from_y, Lanes to_x, Lanes to_y) {
    const Lanes l = from_x * to_y, r = from_y * to_x;
    value = l - r;
    bound = multiply_add(magnitude(l + r), same(4 * v), same(tiny));
  }
};

/// Casts the ray to +x from each point against all edges of a ring: shared.numbers holds its vertices, x and y in turn,
/// which are finite; there are shared.count of them.
///
/// An edge from a to b crosses the ray's line if exactly one of a.y and b.y is greater than the point's y; those are
/// comparisons, and exact. It crosses the ray if the turn of a, b and the point has the sign of b.y - a.y, with the
/// bound of Turn. A point on the boundary is on an edge that crosses the line, and then the turn is 0; or on a
/// horizontal edge or a vertex, and then it has the y of a vertex.
class Ring {
 public:
  static constexpr std::size_t columns = 2;

#ifdef TOUCHSTONE_SECOND_STAGE
  static Located closely(const Shared& shared, const Lanes* p) {
    Mask odd = 0, on = 0, open = ~finite<columns>(p);
    Waiting waiting;
    const auto look = [&] {
      const Lanes first = same(0), last = same(static_cast<double>(shared.count - 1)), to = waiting.part;
      const Lanes from = chosen(equal(to, first), last, to - same(1));
      const Sides turn = exact_turn({shared.numbers, 2, from}, {shared.numbers, 2, to}, p, waiting.asked);
      odd ^= turn.known() & (turn.right ^ above(Gathered(shared.numbers, 2, to)[1], p[1]));
      on |= turn.on, open |= waiting.asked & ~turn.known();
      waiting.asked = 0;
    };
    for_each_edge(shared, p, [&](const Edge& edge, std::size_t vertex) {
      const Mask inconclusive = edge.inconclusive();
      odd ^= edge.crosses & ~inconclusive & (edge.turn.set ^ edge.b_higher);
      if (edge.level != 0) on |= edge.ends_or_lies_at(p);
      if (!waiting.has_room(inconclusive)) look();
      waiting.add(inconclusive, vertex);
    });
    look();
    return {on | ~open, ~odd, on};
  }
#endif

 private:
  struct Edge {
    const double *a, *b;
    Verdict turn;
    Mask crosses, b_higher, level;  ///< level: the points with the y of b
    Mask inconclusive() const { return crosses & ~turn.known; }
    Mask ends_or_lies_at(const Lanes* p) const {
      const Mask between = equal(same(a[1]), p[1]) & (above(same(a[0]), p[0]) ^ above(same(b[0]), p[0]));
      return level & (equal(same(b[0]), p[0]) | between);
    }
  };

  /// Calls look(edge, number of the vertex at its end).
  template <class Look>
  [[gnu::always_inline]] static void for_each_edge(const Shared& shared, const Lanes* p, const Look& look) {
    const double* a = shared.numbers + 2 * (shared.count - 1);
    Lanes from_x = same(a[0]) - p[0], from_y = same(a[1]) - p[1];
    Mask higher = above(same(a[1]), p[1]);
    for (std::size_t vertex = 0; vertex < shared.count; ++vertex) {
      const double* const b = shared.numbers + 2 * vertex;
      const Lanes by = same(b[1]), to_x = same(b[0]) - p[0], to_y = by - p[1];
      const Mask b_higher = above(by, p[1]);
      const TurnSeen seen(from_x, from_y, to_x, to_y);
      look(Edge{a, b, by_sign(seen.value, seen.bound), higher ^ b_higher, b_higher, equal(by, p[1])}, vertex);
      from_x = to_x, from_y = to_y, higher = b_higher, a = b;
    }
  }

#ifdef TOUCHSTONE_SECOND_STAGE
  [[gnu::noinline]] static Sides exact_turn(const Gathered& from, const Gathered& to, const Lanes* point, Mask asked) {
    const Lanes a[] = {from[0], from[1]}, b[] = {to[0], to[1]};
    Sides turn = close_turn({b[0], a[0]}, {b[1], a[1]}, {point[1], a[1]}, {point[0], a[0]});
    settle(turn, a, b, point, asked);
    return {turn.left & asked, turn.right & asked, turn.on & asked};
  }
#endif
};

/// The side of every face of a convex solid on which each point lies: outside of one, on one, or inside of all.
/// shared.numbers holds the numbers of shared.count faces.
struct ConvexSolid {
  static constexpr std::size_t columns = 3;

#ifdef TOUCHSTONE_SECOND_STAGE
  static Located closely(const Shared& shared, const Lanes* p) {
    Mask out = 0, on = 0, open = 0;
    Waiting waiting;
    const auto look = [&] {
      const Signs side = exact_side({shared.numbers, of_face, waiting.part}, p, waiting.asked);
      out |= side.positive, on |= side.zero, open |= waiting.asked & ~side.known();
      waiting.asked = 0;
    };
    for (std::size_t face = 0; face < shared.count && out != all_lanes; ++face) {
      const Certain side = side_of_face(shared.numbers + of_face * face, p);
      out |= side.positive;
      const Mask inconclusive = all_lanes & ~(out | open | side.negative);
      if (!waiting.has_room(inconclusive)) look();
      waiting.add(inconclusive, face);
    }
    look();
    return {out | ~open, out, on & ~out};
  }
#endif
};

/// Writes a byte for each point of a chunk: inside 0, on the boundary 1, outside 2.
template <class Shape>
void filter_beside(const double* const* columns, const std::size_t* steps, std::size_t chunks, const Shared& shared,
                   std::uint8_t* answers, std::uint64_t* unknown) {
  for (std::size_t n = 0; n < chunks; ++n) {
    std::uint64_t known = 0, outside = 0;
    for (std::size_t i = 0; i < chunk; i += lanes) {
      Lanes p[Shape::columns];
      for (std::size_t k = 0; k < Shape::columns; ++k) p[k] = Lanes::at(columns[k] + n * steps[k] + i);
      const Located found = Shape::filtered(shared, p);
      known |= static_cast<std::uint64_t>(found.known & all_lanes) << i;
      outside |= static_cast<std::uint64_t>(found.outside & all_lanes) << i;
    }
    unknown[n] = ~known;
    put_bytes(answers + n * chunk, outside, 2, 0);
  }
}

#ifdef TOUCHSTONE_SECOND_STAGE

template <class Shape>
struct CloseBeside {
  static constexpr std::size_t columns = Shape::columns;
  static constexpr bool of_lengths = false;
  static Decision of(const Lanes* p, Mask, const Shared& shared) {
    const Located found = Shape::closely(shared, p);
    return {found.known, found.on, found.outside & ~found.on};
  }
};

#else

template <class Shape>
struct CloseBeside;

#endif

}  // namespace
}  // namespace touchstone::robust::batch::isa
