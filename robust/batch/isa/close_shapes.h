// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/close.h"

/// Second stages of planes, boxes and balls, like those of close.h: exact signs, and comparisons.
namespace touchstone::robust::batch::isa {
namespace {

#ifdef TOUCHSTONE_SECOND_STAGE

/// The sum of three products and the offset, in seven terms, all multiples of 2^-1064 if all numbers are in the window.
/// A normal of length 0 is to be refused.
struct ClosePointPlane {
  static constexpr std::size_t columns = 7;
  static constexpr bool of_lengths = false;
  static Decision of(const Lanes* c, Mask asked) {
    Mask valid = above(magnitude(c[0]) + magnitude(c[1]) + magnitude(c[2]), same(0));
    for (std::size_t k = 0; k < columns; ++k) valid &= in_window(c[k]);
    const Product x(c[0], c[4]), y(c[1], c[5]), z(c[2], c[6]);
    Lanes terms[] = {x.tail, y.tail, z.tail, x.head, y.head, z.head, c[3]};
    const Signs signs = signs_of_sums(terms, asked & valid);
    return {valid & signs.known(), signs.zero, signs.negative};
  }
};

/// Comparisons decide: the boxes are disjoint if on some axis one ends before the other begins; otherwise they touch if
/// on some axis one ends at the beginning of the other, or has no extent.
template <std::size_t dimensions>
struct CloseBoxes {
  static constexpr std::size_t columns = 4 * dimensions;
  static constexpr bool of_lengths = false;
  static Decision of(const Lanes* c, Mask) {
    constexpr std::size_t n = dimensions;
    Mask valid = all_lanes, apart = 0, touch = 0;
    for (std::size_t k = 0; k < columns; ++k) valid &= not_below(same(0x1.fffffffffffffp1023), magnitude(c[k]));
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes a_min = c[k], a_max = c[n + k], b_min = c[2 * n + k], b_max = c[3 * n + k];
      valid &= not_below(a_max, a_min) & not_below(b_max, b_min);
      apart |= above(a_min, b_max) | above(b_min, a_max);
      touch |= equal(a_min, b_max) | equal(b_min, a_max) | equal(a_min, a_max) | equal(b_min, b_max);
    }
    return {valid, touch & ~apart, ~(touch | apart)};
  }
};

/// Adds the six terms of the square of a head and a tail, each group of terms after smaller ones: place `at` of `count`
/// squares.
template <std::size_t count>
void add_square(Lanes (&terms)[6 * count], std::size_t at, Lanes head, Lanes tail, bool minus) {
  const Lanes by_head = minus ? opposite(head) : head, by_tail = minus ? opposite(tail) : tail;
  const Product great(by_head, head), middle(by_head + by_head, tail), least(by_tail, tail);
  terms[at] = least.tail, terms[count + at] = least.head;
  terms[2 * count + at] = middle.tail, terms[3 * count + at] = middle.head;
  terms[4 * count + at] = great.tail, terms[5 * count + at] = great.head;
}

/// The square of the sum of the radii minus that of the distance. A ball of radius 0 has no interior: it can only
/// touch.
///
/// A speck, a radius below 2^-720 while the other numbers are 0 or between 2^-200 and 2^200, is left out: the others
/// are multiples of 2^-252, and the value without it is a multiple of 2^-504. Specks add less than 2^-510, so they
/// decide only if the value is 0.
template <std::size_t dimensions>
struct CloseSpheres {
  static constexpr std::size_t columns = 2 * dimensions + 2;
  static constexpr bool of_lengths = true;
  static Decision of(const Lanes* c, Mask asked) {
    constexpr std::size_t n = dimensions;
    Lanes radii[] = {c[n], c[2 * n + 1]};
    const Lanes smaller = lesser(radii[0], radii[1]);
    Mask valid = not_below(smaller, same(0)), specks = 0;
    for (Lanes& radius : radii) {
      const Mask speck = above(radius, same(0)) & above(same(0x1p-720), radius);
      radius = chosen(speck, same(0), radius), specks |= speck;
    }
    const Mask wide = ~specks & all_lanes;
    const auto in_own_window = [&](Lanes x) { return in_window(x, 0x1p200) | (wide & in_window(x)); };
    valid &= in_own_window(radii[0]) & in_own_window(radii[1]);
    Lanes terms[6 * (n + 1)];
    for (std::size_t k = 0; k < n; ++k) {
      valid &= in_own_window(c[k]) & in_own_window(c[n + 1 + k]);
      const Difference way(c[n + 1 + k], c[k]);
      add_square<n + 1>(terms, k, way.head, way.tail, true);
    }
    const Sum reach(radii[0], radii[1]);
    add_square<n + 1>(terms, n, reach.head, reach.tail, false);
    const Signs signs = signs_of_sums(terms, asked & valid);
    const Mask solid = above(smaller, same(0)), inside = signs.positive | (signs.zero & specks);
    return {valid & signs.known(), (signs.zero & ~specks) | (inside & ~solid), inside & solid};
  }
};

/// The square of the radius minus that of the distance of the center from the nearest point of the box, each coordinate
/// of which is one of the given numbers. A ball or a box without an interior can only touch.
template <std::size_t dimensions>
struct CloseSphereBox {
  static constexpr std::size_t columns = 3 * dimensions + 1;
  static constexpr bool of_lengths = true;
  static Decision of(const Lanes* c, Mask asked) {
    constexpr std::size_t n = dimensions;
    const Lanes radius = c[n];
    Mask valid = not_below(radius, same(0)), solid = above(radius, same(0));
    for (std::size_t k = 0; k < columns; ++k) valid &= in_window(c[k]);
    Lanes terms[6 * (n + 1)];
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes center = c[k], min = c[n + 1 + k], max = c[2 * n + 1 + k];
      valid &= not_below(max, min), solid &= above(max, min);
      const Difference way(center, lesser(greater(center, min), max));
      add_square<n + 1>(terms, k, way.head, way.tail, true);
    }
    add_square<n + 1>(terms, n, radius, same(0), false);
    const Signs signs = signs_of_sums(terms, asked & valid);
    return {valid & signs.known(), signs.zero | (signs.positive & ~solid), signs.positive & solid};
  }
};

/// A ray misses a box if it leaves it along some axis before the ray begins, or before it enters along another axis.
/// Times are distances divided by speeds, and the sign of a sum of four products tells which of two is later. Along an
/// axis on which the direction is 0, comparisons decide.
template <std::size_t dimensions>
struct CloseRayBox {
  static constexpr std::size_t columns = 4 * dimensions;
  static constexpr bool of_lengths = true;

  struct OfAxis {
    Lanes speed = same(0);
    Difference entry{same(0), same(0)}, exit{same(0), same(0)};
    Mask moves = 0;
  };

  static Decision of(const Lanes* c, Mask asked) {
    constexpr std::size_t n = dimensions;
    Mask valid = asked, apart = 0, leads = 0;
    OfAxis axes[n];
    for (std::size_t k = 0; k < 4 * n; ++k) valid &= in_window(c[k]);
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes from = c[k], way = c[n + k], min = c[2 * n + k], max = c[3 * n + k];
      const Mask back = negative(way);
      OfAxis& axis = axes[k];
      axis.speed = magnitude(way);
      axis.entry = Difference(chosen(back, from, min), chosen(back, max, from));
      axis.exit = Difference(chosen(back, from, max), chosen(back, min, from));
      axis.moves = above(axis.speed, same(0));
      leads |= axis.moves;
      valid &= not_below(max, min);
      apart |= above(same(0), axis.exit.head) | (above(axis.entry.head, same(0)) & ~axis.moves);
    }
    valid &= leads;
    Mask known = valid;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const Mask open = valid & ~apart & axes[i].moves & axes[j].moves;
        if (i == j || open == 0) continue;
        const Signs later = order(axes[i], axes[j], open);
        apart |= open & later.positive;
        known &= ~open | later.known();
      }
    }
    return {valid & (apart | known), ~apart, 0};
  }

  /// The sign of the entry along one axis minus the exit along another.
  static Signs order(const OfAxis& in, const OfAxis& out, Mask asked) {
    const Product late(in.entry.head, out.speed), soon(opposite(out.exit.head), in.speed);
    const Product late_rest(in.entry.tail, out.speed), soon_rest(opposite(out.exit.tail), in.speed);
    Lanes terms[] = {late_rest.tail, soon_rest.tail, late_rest.head, soon_rest.head,
                     late.tail,      soon.tail,      late.head,      soon.head};
    return signs_of_sums(terms, asked);
  }
};

#else

struct ClosePointPlane;
template <std::size_t dimensions>
struct CloseRayBox;
template <std::size_t dimensions>
struct CloseBoxes;
template <std::size_t dimensions>
struct CloseSpheres;
template <std::size_t dimensions>
struct CloseSphereBox;

#endif

}  // namespace
}  // namespace touchstone::robust::batch::isa
