// SPDX-License-Identifier: Apache-2.0
// A unit for each instruction set includes this, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/kernels.h"

/// The second stage of arrays, for rows that a filter leaves: products with their rounding errors, which an FMA tells.
/// Unit by unit, for instruction sets that have one.
namespace touchstone::robust::batch::isa {
namespace {

#if TOUCHSTONE_LANES > 2

/// x - y and what rounding left out, exactly: sum and error of Knuth's two-sum.
struct Difference {
  Lanes head, tail;
  Difference(Lanes x, Lanes y) : head(x - y), tail(x) {
    const Lanes y_part = x - head, x_part = head + y_part;
    tail = (x - x_part) + (y_part - y);
  }
};

/// x y and what rounding left out, exactly.
struct Product {
  Lanes head, tail;
  Product(Lanes x, Lanes y) : head(x * y), tail(multiply_add(x, y, same(0) - head)) {}
};

/// The lanes of numbers that are 0 or between 2^-480 and 2^480.
Mask in_window(Lanes x) {
  const Lanes size = magnitude(x);
  return (not_below(size, same(0x1p-480)) & not_below(same(0x1p480), size)) | equal(size, same(0));
}

/// How three points turn, with an answer for `on` too.
///
/// The coordinates are in the window: they are multiples of 2^-532, and so are their differences, with both parts; what
/// rounding leaves out of a product of two of these is a multiple of 2^-1064. So nothing here underflows or overflows,
/// and all heads and tails are exact.
///
/// Where no difference was rounded, the turn is the difference of two exact products, L + l and R + r in heads and
/// tails. Rounding is monotone: L > R says that the first is greater, and where L = R the tails decide.
///
/// Elsewhere let the differences be u + u', v + v', w + w', x + x' and S = |L| + |R|. The turn is (L - R) + ((l - r) +
/// ((u v' + v u') - (w x' + x w'))) + (u' v' - w' x'). The last is at most 2 v^2 S and left out. Every sum inside of
/// the outermost one is made of terms that are at most 2 v (1 + 4 v) S in all; with the products rounded first, what
/// their roundings add is less than 14 v^2 S. L - R is off by v |L - R|, and the outermost sum by v times itself. L - R
/// is at most (1 + v) times the sum and 4 v S; so the value is off by less than 3 v |value| + 32 v^2 S, 2^-51 |value| +
/// 2^-101 S. The bound has 2^-50 and 2^-98.
struct CloseTurn {
  Mask left, right, on;
  CloseTurn(Lanes px, Lanes py, Lanes qx, Lanes qy, Lanes x, Lanes y, Mask window) {
    const Lanes zero = same(0);
    const Difference u(qx, px), w(qy, py), s(y, py), t(x, px);
    const Product l(u.head, s.head), r(w.head, t.head);
    const Lanes tails = magnitude(u.tail) + magnitude(w.tail) + magnitude(s.tail) + magnitude(t.tail);
    const Mask plain = equal(tails, zero) & window, tie = equal(l.head, r.head);
    const Lanes of_tails = (u.head * s.tail + s.head * u.tail) - (w.head * t.tail + t.head * w.tail);
    const Lanes value = (l.head - r.head) + ((l.tail - r.tail) + of_tails), size = magnitude(value);
    const Lanes bound = multiply_add(magnitude(l.head) + magnitude(r.head), same(0x1p-98), size * same(0x1p-50));
    const Mask sure = above(size, bound) & window & ~plain;
    left = (plain & (above(l.head, r.head) | (tie & above(l.tail, r.tail)))) | (sure & ~negative(value));
    right = (plain & (above(r.head, l.head) | (tie & above(r.tail, l.tail)))) | (sure & negative(value));
    on = plain & tie & equal(l.tail, r.tail);
  }
  Mask known() const { return left | right | on; }
};

/// The rows that a stage decides, and of these the rows with the answers 1 and 2; the others have 0.
struct Decision {
  Mask known, one, two;
};

struct CloseOrientation {
  static constexpr std::size_t columns = 6;
  static Decision of(const Lanes* c) {
    Mask window = all_lanes;
    for (std::size_t k = 0; k < columns; ++k) window &= in_window(c[k]);
    const CloseTurn turn(c[0], c[1], c[2], c[3], c[4], c[5], window);
    return {turn.known(), turn.on, turn.right};
  }
};

/// On the line of the segment, and within its box.
struct ClosePointOnSegment {
  static constexpr std::size_t columns = 6;
  static Decision of(const Lanes* c) {
    Mask window = all_lanes;
    for (std::size_t k = 0; k < columns; ++k) window &= in_window(c[k]);
    const Lanes x = c[0], y = c[1];
    const CloseTurn turn(c[2], c[3], c[4], c[5], x, y, window);
    const Mask within = not_below(x, lesser(c[2], c[4])) & not_below(greater(c[2], c[4]), x) &
                        not_below(y, lesser(c[3], c[5])) & not_below(greater(c[3], c[5]), y);
    return {turn.known(), ~(turn.on & within), 0};
  }
};

/// Disjoint where an axis or the line of one segment has the other strictly on one side; elsewhere a point, unless all
/// four ends are on one line.
struct CloseSegmentSegment {
  static constexpr std::size_t columns = 8;
  static Decision of(const Lanes* c) {
    Mask window = all_lanes;
    for (std::size_t k = 0; k < columns; ++k) window &= in_window(c[k]);
    const Lanes ax = c[0], ay = c[1], bx = c[2], by = c[3], px = c[4], py = c[5], qx = c[6], qy = c[7];
    const CloseTurn to_p(ax, ay, bx, by, px, py, window), to_q(ax, ay, bx, by, qx, qy, window);
    const CloseTurn to_a(px, py, qx, qy, ax, ay, window), to_b(px, py, qx, qy, bx, by, window);
    const Mask beside = above(lesser(px, qx), greater(ax, bx)) | above(lesser(ax, bx), greater(px, qx)) |
                        above(lesser(py, qy), greater(ay, by)) | above(lesser(ay, by), greater(py, qy));
    const Mask apart = (beside & window) | (to_p.left & to_q.left) | (to_p.right & to_q.right) |
                       (to_a.left & to_b.left) | (to_a.right & to_b.right);
    const Mask all = to_p.known() & to_q.known() & to_a.known() & to_b.known() & ~(to_p.on & to_q.on);
    return {apart | all, all & ~apart, 0};
  }
};

template <class F>
void close(const double* const* columns, const std::size_t* steps, std::size_t chunks, const Shared&,
           std::uint8_t* answers, std::uint64_t* unknown) {
  for (std::size_t n = 0; n < chunks; ++n) {
    std::uint64_t known = 0, one = 0, two = 0;
    for (std::size_t i = 0; i < chunk; i += lanes) {
      Lanes numbers[F::columns];
      for (std::size_t k = 0; k < F::columns; ++k) numbers[k] = Lanes::at(columns[k] + n * steps[k] + i);
      const Decision found = F::of(numbers);
      known |= static_cast<std::uint64_t>(found.known & all_lanes) << i;
      one |= static_cast<std::uint64_t>(found.one & all_lanes) << i;
      two |= static_cast<std::uint64_t>(found.two & all_lanes) << i;
    }
    unknown[n] = ~known;
    std::uint8_t ones[chunk], twos[chunk];
    put_bytes(ones, one, 1, 0);
    put_bytes(twos, two, 2, 0);
    for (std::size_t i = 0; i < chunk; ++i) answers[n * chunk + i] = ones[i] | twos[i];
  }
}

template <class F>
constexpr Filter* close_stage = close<F>;

#else

struct CloseOrientation;
struct ClosePointOnSegment;
struct CloseSegmentSegment;
template <class F>
constexpr Filter* close_stage = nullptr;

#endif

}  // namespace
}  // namespace touchstone::robust::batch::isa
