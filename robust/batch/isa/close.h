// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/sums.h"

/// The second stage of arrays, for the near-degenerate and degenerate rows that a filter leaves: products with their
/// rounding errors, and if these do not decide, exact signs. Compiled per unit, for instruction sets that have an FMA.
namespace touchstone::robust::batch::isa {
namespace {

#ifdef TOUCHSTONE_SECOND_STAGE

/// The lanes in which three points certainly turn left, turn right, or are collinear.
struct Sides {
  Mask left, right, on = 0;
  Mask known() const { return left | right | on; }
  Sides opposite() const { return {right, left, on}; }
};

/// The turn of three points, from the differences u + u' and w + w', of the second and the first, in x and y, and t +
/// t' and s + s', of the third and the first, with their rounding errors. Never finds points collinear.
///
/// Let L + l and R + r be the products u s and w t in heads and tails, and S = |L| + |R|. The turn is (L - R) + ((l -
/// r) + ((u s' + s u') - (w t' + t w'))) + (u' s' - w' t'). The last is at most v^2 S and left out. Among the terms in
/// the middle l and r add up to v S at most, the others to 2 v S, up to terms of higher order. The roundings of the
/// four products add 2 v^2 S, those of the sums of two 2 v^2 S and v^2 S, of the difference of these 2 v^2 S, and of
/// the sum in the middle 3 v^2 S: 11 v^2 S with what is left out. L - R is off by v |L - R|, and the outermost sum by v
/// times itself; L - R is at most the value and 3 v S. So the value is off by less than 2 v |value| + 14 v^2 S, with
/// all terms of higher order 3 v |value| + 16 v^2 S. The bound has 2^3 v and 2^8 v^2.
///
/// Underflow. Sums that underflow are exact. Each of the eight products, and each tail of one, may be off by 2^-1075
/// more: 2^-1000 pays for that. An FMA leaves out roundings.
///
/// Overflow, infinite or NaN numbers. Every number is in a head, which is then infinite or NaN, and with it a product
/// and S; so is a tail, where anything in it overflows, and with it the value. |value| > bound is false if the bound is
/// NaN or both are infinite, and the bound is infinite if S or the value is.
///
/// Proved by machine from this text (robust/proofs/lane_close.v).
Sides close_turn(const Difference& u, const Difference& w, const Difference& s, const Difference& t) {
  const Product l(u.head, s.head), r(w.head, t.head);
  const Lanes first = multiply_add(u.head, s.tail, s.head * u.tail);
  const Lanes second = multiply_add(w.head, t.tail, t.head * w.tail);
  const Lanes value = (l.head - r.head) + ((l.tail - r.tail) + (first - second)), size = magnitude(value);
  const Lanes of_value = multiply_add(size, same(8 * v), same(tiny));
  const Lanes bound = multiply_add(magnitude(l.head) + magnitude(r.head), same(256 * v * v), of_value);
  const Mask sure = above(size, bound), below = negative(value);
  return {sure & ~below, sure & below};
}

/// Decides the missing turns of the asked lanes exactly, of differences of numbers in the window.
///
/// If no difference was rounded, the turn is the difference of two products, in heads and tails. Rounding is monotone:
/// if one head is greater, so is its product, and if the heads are equal the tails decide. Otherwise the turn is the
/// sum of eight products, in sixteen terms.
[[gnu::noinline]] void settle(Sides& sides, const Difference& u, const Difference& w, const Difference& s,
                              const Difference& t, Mask asked) {
  asked &= ~sides.known();
  const Product one(u.head, s.head), other(w.head, t.head);
  const Lanes tails = magnitude(u.tail) + magnitude(w.tail) + magnitude(s.tail) + magnitude(t.tail);
  const Mask plain = asked & equal(tails, same(0)), tie = equal(one.head, other.head);
  sides.left |= plain & (above(one.head, other.head) | (tie & above(one.tail, other.tail)));
  sides.right |= plain & (above(other.head, one.head) | (tie & above(other.tail, one.tail)));
  sides.on |= plain & tie & equal(one.tail, other.tail);
  asked &= ~plain;
  if (asked == 0) return;
  const Lanes w_head = opposite(w.head), w_tail = opposite(w.tail);
  const Product us(u.head, s.tail), su(s.head, u.tail), wt(w_head, t.tail), tw(t.head, w_tail);
  const Product least_us(u.tail, s.tail), least_wt(w_tail, t.tail);
  Lanes terms[] = {least_us.tail, least_wt.tail,
                   least_us.head, least_wt.head,
                   us.tail,       su.tail,
                   wt.tail,       tw.tail,
                   us.head,       su.head,
                   wt.head,       tw.head,
                   one.tail,      opposite(other.tail),
                   one.head,      opposite(other.head)};
  const Signs signs = signs_of_sums(terms, asked);
  sides.left |= asked & signs.positive;
  sides.right |= asked & signs.negative;
  sides.on |= asked & signs.zero;
}

/// The same of the turns of three points, if all their coordinates are in the window.
[[gnu::noinline]] void settle(Sides& sides, const Lanes* p, const Lanes* q, const Lanes* r, Mask asked) {
  asked &= ~sides.known();
  const Lanes* const points[] = {p, q, r};
  for (const Lanes* const point : points) asked &= in_window(point[0]) & in_window(point[1]);
  if (asked != 0) settle(sides, {q[0], p[0]}, {q[1], p[1]}, {r[1], p[1]}, {r[0], p[0]}, asked);
}

/// The rows that a stage decides, and among these the rows with the answers 1, 2 and 3; the others have 0. A stage is
/// of_lengths if all numbers may be multiplied by one factor.
struct Decision {
  Mask known, one, two, three = 0;
};

struct CloseOrientation {
  static constexpr std::size_t columns = 6;
  static constexpr bool of_lengths = true;
  static Decision of(const Lanes* c, Mask asked) {
    Sides turn = close_turn({c[2], c[0]}, {c[3], c[1]}, {c[5], c[1]}, {c[4], c[0]});
    if ((asked & ~turn.known()) != 0) settle(turn, c, c + 2, c + 4, asked);
    return {turn.known(), turn.on, turn.right};
  }
};

/// True if the point is on the segment's line and within its box.
struct ClosePointOnSegment {
  static constexpr std::size_t columns = 6;
  static constexpr bool of_lengths = true;
  static Decision of(const Lanes* c, Mask asked) {
    const Lanes x = c[0], y = c[1];
    Sides turn = close_turn({c[4], c[2]}, {c[5], c[3]}, {y, c[3]}, {x, c[2]});
    if ((asked & ~turn.known()) != 0) settle(turn, c + 2, c + 4, c, asked);
    const Mask within = not_below(x, lesser(c[2], c[4])) & not_below(greater(c[2], c[4]), x) &
                        not_below(y, lesser(c[3], c[5])) & not_below(greater(c[3], c[5]), y);
    return {turn.known(), ~(turn.on & within), 0};
  }
};

/// The segments are disjoint if an axis or the line of one segment has the other strictly on one side; otherwise they
/// meet. If all four ends are collinear they meet in the intersection of their boxes, which is more than a point if it
/// has an extent along an axis; otherwise they meet in a point. Both ends of each segment are on the other's line only
/// if all are collinear: the line of the other, if that has a length, has a segment without length that is not on it
/// strictly on one side.
struct CloseSegmentSegment {
  static constexpr std::size_t columns = 8;
  static constexpr bool of_lengths = true;

  struct Turns {
    Sides to_p, to_q, to_a, to_b;
    Mask apart() const {
      return (to_p.left & to_q.left) | (to_p.right & to_q.right) | (to_a.left & to_b.left) | (to_a.right & to_b.right);
    }
    Mask known() const { return to_p.known() & to_q.known() & to_a.known() & to_b.known(); }
    Mask on_one_line() const { return to_p.on & to_q.on & to_a.on & to_b.on; }
  };

  static Decision of(const Lanes* c, Mask asked) {
    const Lanes ax = c[0], ay = c[1], bx = c[2], by = c[3], px = c[4], py = c[5], qx = c[6], qy = c[7];
    const Difference abx(bx, ax), aby(by, ay), pqx(qx, px), pqy(qy, py);
    const Difference apx(px, ax), apy(py, ay), aqx(qx, ax), aqy(qy, ay), pbx(bx, px), pby(by, py);
    // The difference from p to a is the negated difference from a to p.
    Turns turns{close_turn(abx, aby, apy, apx), close_turn(abx, aby, aqy, aqx),
                close_turn(pqx, pqy, apy, apx).opposite(), close_turn(pqx, pqy, pby, pbx)};
    const Lanes a_left = lesser(ax, bx), a_right = greater(ax, bx), a_low = lesser(ay, by), a_high = greater(ay, by);
    const Lanes p_left = lesser(px, qx), p_right = greater(px, qx), p_low = lesser(py, qy), p_high = greater(py, qy);
    const Mask beside = above(p_left, a_right) | above(a_left, p_right) | above(p_low, a_high) | above(a_low, p_high);
    const Lanes total = ((magnitude(ax) + magnitude(ay)) + (magnitude(bx) + magnitude(by))) +
                        ((magnitude(px) + magnitude(py)) + (magnitude(qx) + magnitude(qy)));
    const Mask of_boxes = beside & not_below(same(0x1.fffffffffffffp1023), total);  // all numbers are finite
    Mask apart = of_boxes | turns.apart();
    const Mask open = asked & ~(apart | turns.known());
    if (open == 0) return {apart | turns.known(), ~apart, 0};
    settle(turns.to_p, c, c + 2, c + 4, open);
    settle(turns.to_q, c, c + 2, c + 6, open);
    settle(turns.to_a, c + 4, c + 6, c, open);
    settle(turns.to_b, c + 4, c + 6, c + 2, open);
    apart |= turns.apart();
    const Mask longer =
        above(lesser(a_right, p_right), greater(a_left, p_left)) | above(lesser(a_high, p_high), greater(a_low, p_low));
    const Mask overlap = turns.on_one_line() & longer & ~apart;
    return {apart | turns.known(), ~(apart | overlap), overlap};
  }
};

template <class F>
std::uint64_t close(const double* const* columns, std::uint64_t asked, const Shared& shared, std::uint8_t* answers) {
  std::uint64_t known = 0, one = 0, two = 0, three = 0;
  for (std::size_t i = 0; i < chunk; i += lanes) {
    const Mask here = static_cast<Mask>(asked >> i) & all_lanes;
    if (here == 0) continue;
    Lanes numbers[F::columns];
    for (std::size_t k = 0; k < F::columns; ++k) numbers[k] = Lanes::at(columns[k] + i);
    if constexpr (F::of_lengths) bring_near_one(numbers);
    Decision found;
    if constexpr (requires { F::of(numbers, here, shared); }) found = F::of(numbers, here, shared);
    else found = F::of(numbers, here);
    known |= static_cast<std::uint64_t>(found.known & here) << i;
    one |= static_cast<std::uint64_t>(found.one & here) << i;
    two |= static_cast<std::uint64_t>(found.two & here) << i;
    three |= static_cast<std::uint64_t>(found.known & found.three & here) << i;
  }
  put_answers(answers, known, one, two);
  for (; three != 0; three &= three - 1) answers[__builtin_ctzll(three)] = 3;
  return asked & ~known;
}

template <class F>
constexpr SecondStage* close_stage = close<F>;

#else

struct CloseOrientation;
struct ClosePointOnSegment;
struct CloseSegmentSegment;
template <class F>
constexpr SecondStage* close_stage = nullptr;

#endif

}  // namespace
}  // namespace touchstone::robust::batch::isa
