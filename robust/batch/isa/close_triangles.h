// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/close_plane.h"

/// Second stages of triangles in space, like those of close.h. Every volume of coplanar shapes is 0, and of triangles
/// without area; close_plane.h has what decides these.
namespace touchstone::robust::batch::isa {
namespace {

#ifdef TOUCHSTONE_SECOND_STAGE

/// A displacement with its rounding error.
struct Way {
  Difference x, y, z;
  Way(const InSpace& to, const InSpace& from) : x(to.x, from.x), y(to.y, from.y), z(to.z, from.z) {}
  Lanes tails() const { return magnitude(x.tail) + magnitude(y.tail) + magnitude(z.tail); }
};

/// v x w of displacements between points in the window of cubes, and the signs of its scalar products with such
/// displacements.
///
/// Let p q and r s be the exact products of a coordinate, L + l and R + t those of their heads, S = |L| + |R|, and D +
/// d the difference of L and R. The coordinate is D and a tail: d, l - t and the four products of a head and a tail.
/// The tail is at most 4 v S and off by 15 v^2 S: v^2 S for l - t, 2 for the four products, 2 for the sums of two, 2
/// for the difference of these, 3 and 4 for the last two sums, 1 for the products of two tails, which are left out.
/// Times the third displacement, h + k, in units of v^2 S |h|: 15 from that, 4 for the product of two tails, left out,
/// 1 and 4 for the products, 5 and 6 for their sums; the rest besides D h, rounded, is at most 6 v S |h|. The three of
/// these are added (12), and to them the errors of the two sums of D h (2 and 8): 57 v^2 P in all, P being the sum of
/// S |h|, and the last sum cannot make a sign wrong. The bound is 2^7 v^2 P, which pays for all terms of higher order.
///
/// Nothing underflows or overflows: all numbers are multiples of 2^-302, so all products are of 2^-906.
class CloseNormal {
 public:
  CloseNormal(const Way& v, const Way& w)
      : x_(v.y, w.z, v.z, w.y), y_(v.z, w.x, v.x, w.z), z_(v.x, w.y, v.y, w.x), tails_(v.tails() + w.tails()) {}

  /// If nothing was rounded, the sign is that of the value, even 0.
  Signs along(const Way& d, Mask asked) const {
    const Lanes zero = same(0);
    Lanes low = zero, size = zero, rounded = tails_ + d.tails();
    const auto add = [&](const Coordinate& n, const Difference& way) {
      const Product term(n.value.head, way.head);
      low = low + (term.tail + (n.value.head * way.tail + n.tail * way.head));
      size = multiply_add(n.size, magnitude(way.head), size);
      rounded = rounded + (n.rounded + magnitude(term.tail));
      return term.head;
    };
    const Lanes in_x = add(x_, d.x), in_y = add(y_, d.y), in_z = add(z_, d.z);
    const Sum two(in_x, in_y), all(two.head, in_z);
    const Lanes value = all.head + ((two.tail + all.tail) + low);
    rounded = rounded + (magnitude(two.tail) + magnitude(all.tail));
    const Mask exact = equal(rounded, zero), sure = exact | above(magnitude(value), size * same(128 * v * v));
    Signs found{sure & above(value, zero), sure & above(zero, value), exact & equal(value, zero)};
    if ((asked & ~found.known()) != 0) settle(found, d, asked);
    return found;
  }

 private:
  struct Coordinate {
    Product first, second;
    Difference value;
    Lanes tail, size, rounded;
    Coordinate(const Difference& p, const Difference& q, const Difference& r, const Difference& s)
        : first(p.head, q.head), second(r.head, s.head), value(first.head, second.head) {
      const Lanes of_first = multiply_add(p.head, q.tail, p.tail * q.head);
      const Lanes of_second = multiply_add(r.head, s.tail, r.tail * s.head);
      tail = value.tail + ((first.tail - second.tail) + (of_first - of_second));
      size = magnitude(first.head) + magnitude(second.head);
      rounded = magnitude(value.tail) + magnitude(first.tail) + magnitude(second.tail);
    }
    void add_terms(Lanes* terms, Lanes way) const {
      const Lanes back = opposite(way);
      const Product great(first.head, way), least(first.tail, way), other(second.head, back), rest(second.tail, back);
      terms[0] = least.tail, terms[3] = rest.tail, terms[6] = least.head, terms[9] = rest.head;
      terms[12] = great.tail, terms[15] = other.tail, terms[18] = great.head, terms[21] = other.head;
    }
  };

  /// Decides the missing signs exactly if no displacement was rounded: the sum of twelve products.
  [[gnu::noinline]] void settle(Signs& found, const Way& d, Mask asked) const {
    asked &= ~found.known() & equal(tails_ + d.tails(), same(0));
    if (asked == 0) return;
    Lanes terms[24];
    x_.add_terms(terms, d.x.head), y_.add_terms(terms + 1, d.y.head), z_.add_terms(terms + 2, d.z.head);
    const Signs signs = signs_of_sums(terms, asked);
    found.positive |= asked & signs.positive;
    found.negative |= asked & signs.negative;
    found.zero |= asked & signs.zero;
  }

  Coordinate x_, y_, z_;
  Lanes tails_;
};

/// A line that crosses a triangle's plane misses the triangle if it has edges strictly on both sides.
Decision crossing(const Signs& start, const Signs& end, Mask apart, const Signs& ab, const Signs& bc, const Signs& ca,
                  Mask valid) {
  const Mask misses = (ab.positive | bc.positive | ca.positive) & (ab.negative | bc.negative | ca.negative);
  const Mask decided = apart | misses | (ab.known() & bc.known() & ca.known());
  const Mask known = valid & start.known() & end.known() & ~(start.zero & end.zero) & decided;
  return {known, ~(apart | misses), 0};
}

/// Two segments; the second is a triangle without area.
Decision of_segments(const Span& a, const Span& b, Mask valid) {
  const CloseNormal normal(Way(a.greatest, a.least), Way(b.least, a.least));
  const Signs side = normal.along(Way(b.greatest, a.least), valid);
  Decision found{valid & (side.positive | side.negative), 0, 0};
  if ((valid & side.zero) != 0) join(found, of_segments_in_plane(a, b, valid & side.zero));
  return found;
}

Decision of_segment(const InSpace& p, const InSpace& q, const InSpace* t, Mask valid) {
  const CloseNormal normal(Way(t[1], t[0]), Way(t[2], t[0]));
  const Signs at_p = normal.along(Way(p, t[0]), valid), at_q = normal.along(Way(q, t[0]), valid);
  const Mask apart = (at_p.positive & at_q.positive) | (at_p.negative & at_q.negative);
  const Mask in_plane = valid & at_p.zero & at_q.zero, open = valid & ~(apart | in_plane);
  Decision found{valid & apart, 0, 0};
  if (open != 0) {
    const Way line(q, p), to_a(t[0], p), to_b(t[1], p), to_c(t[2], p);
    found = crossing(at_p, at_q, apart, CloseNormal(to_a, to_b).along(line, open),
                     CloseNormal(to_b, to_c).along(line, open), CloseNormal(to_c, to_a).along(line, open), valid);
  }
  if (in_plane == 0) return found;
  found.one &= ~in_plane;
  const SeenTriangle triangle(t, in_plane);
  const Mask flat = in_plane & triangle.with_area, thin = in_plane & triangle.without_area;
  if (flat != 0) join(found, of_segment_in_plane(p, q, triangle, flat));
  if (thin != 0) join(found, of_segments(Span(p, q), Span(t), thin));
  return found;
}

/// The exact stage: stages::segment_triangle::decision::lattice.
struct CloseSegmentTriangle {
  static constexpr std::size_t columns = 15;
  static constexpr bool of_lengths = false;
  static Decision of(Lanes (&n)[columns], Mask asked) {
    const Mask valid = asked & bring_axes_near_one(n);
    const InSpace t[] = {InSpace(n + 6), InSpace(n + 9), InSpace(n + 12)};
    return of_segment(InSpace(n), InSpace(n + 3), t, valid);
  }
};

/// The exact stage: stages::ray_triangle::decision::lattice. A direction of length 0 is to be refused.
struct CloseRayTriangle {
  static constexpr std::size_t columns = 15;
  static constexpr bool of_lengths = false;
  static Decision of(const Lanes* n, Mask asked) {
    const Lanes zero = same(0);
    Lanes near[] = {n[0], n[1], n[2], n[6], n[7], n[8], n[9], n[10], n[11], n[12], n[13], n[14], n[3], n[4], n[5]};
    const Mask leads = above(magnitude(n[3]) + magnitude(n[4]) + magnitude(n[5]), zero);
    const Mask valid = asked & leads & bring_axes_near_one(near, true);
    const InSpace p(near), direction(near + 12), t[] = {InSpace(near + 3), InSpace(near + 6), InSpace(near + 9)};
    const CloseNormal normal(Way(t[1], t[0]), Way(t[2], t[0]));
    const Way line(direction, InSpace(zero, zero, zero)), to_a(t[0], p), to_b(t[1], p), to_c(t[2], p);
    const Signs at_origin = normal.along(Way(p, t[0]), valid), rise = normal.along(line, valid);
    const Mask apart = rise.zero | (at_origin.positive & rise.positive) | (at_origin.negative & rise.negative);
    const Mask in_plane = valid & at_origin.zero & rise.zero, open = valid & ~apart;
    Decision found =
        crossing(at_origin, rise, apart, CloseNormal(to_a, to_b).along(line, open),
                 CloseNormal(to_b, to_c).along(line, open), CloseNormal(to_c, to_a).along(line, open), valid);
    if (in_plane == 0) return found;
    found.one &= ~in_plane;
    const SeenTriangle triangle(t, in_plane);
    const Mask flat = in_plane & triangle.with_area, thin = in_plane & triangle.without_area;
    if (flat != 0) join(found, of_ray_in_plane(p, direction, triangle, flat));
    if (thin != 0) {
      const Span span(t);
      const Signs side = CloseNormal(line, Way(span.least, p)).along(Way(span.greatest, p), thin);
      join(found, {thin & (side.positive | side.negative), 0, 0});
      join(found, of_ray_and_segment_in_plane(p, direction, span, thin & side.zero));
    }
    return found;
  }
};

/// The corner that is alone on its side of the other's plane, or on it, and the other corners
/// (robust/kernel/solids/small_hulls.cpp).
struct CloseTip {
  InSpace corner, others[2];
  Mask on_plane;

  CloseTip(const InSpace* t, const Signs* sides) : corner(t[0]), others{t[1], t[2]} {
    Mask front[3], back[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const Signs &j = sides[(i + 1) % 3], &k = sides[(i + 2) % 3];
      front[i] = sides[i].positive & ~j.positive & ~k.positive;
      back[i] = sides[i].negative & ~j.negative & ~k.negative;
    }
    const Mask in_front = front[0] | front[1] | front[2], behind = ~in_front & (back[0] | back[1] | back[2]);
    on_plane = ~(in_front | behind);
    for (std::size_t i = 1; i < 3; ++i) {
      const Mask here = front[i] | (behind & back[i]) | (on_plane & sides[i].zero);
      corner = chosen(here, t[i], corner);
      others[0] = chosen(here, t[(i + 1) % 3], others[0]), others[1] = chosen(here, t[(i + 2) % 3], others[1]);
    }
  }
};

/// The same decision as in robust/kernel/solids/small_hulls.cpp, which derives it.
struct CloseTriangleTriangle {
  static constexpr std::size_t columns = 18;
  static constexpr bool of_lengths = false;

  /// The sides of the plane of `own` on which the corners of `other` lie.
  struct Corners {
    Signs at[3];
    Corners(const InSpace* own, const InSpace* other, Mask asked) {
      const CloseNormal normal(Way(own[1], own[0]), Way(own[2], own[0]));
      for (std::size_t i = 0; i < 3; ++i) at[i] = normal.along(Way(other[i], own[0]), asked);
    }
    Mask apart() const {
      return (at[0].positive & at[1].positive & at[2].positive) | (at[0].negative & at[1].negative & at[2].negative);
    }
    Mask in_plane() const { return at[0].zero & at[1].zero & at[2].zero; }
    Mask known() const { return at[0].known() & at[1].known() & at[2].known(); }
  };

  static Decision of(Lanes (&n)[columns], Mask asked) {
    const Mask valid = asked & bring_axes_near_one(n);
    const InSpace a[] = {InSpace(n), InSpace(n + 3), InSpace(n + 6)};
    const InSpace b[] = {InSpace(n + 9), InSpace(n + 12), InSpace(n + 15)};
    const Corners of_b(a, b, valid), of_a(b, a, valid & ~of_b.apart());
    const Mask apart = valid & (of_b.apart() | of_a.apart());
    const Mask flat = valid & ~apart & (of_b.in_plane() | of_a.in_plane());
    const Mask open = valid & ~(apart | flat) & of_b.known() & of_a.known();
    Decision found{apart, 0, 0};
    if (open != 0) join(found, across(a, b, of_a, of_b, open));
    if (flat != 0) join(found, in_one_plane(a, b, flat));
    return found;
  }

 private:
  /// The corners of one are in the plane of the other, or this has no area.
  static Decision in_one_plane(const InSpace* a, const InSpace* b, Mask asked) {
    const SeenTriangle first(a, asked), second(b, asked);
    const Mask flat = asked & first.with_area & second.with_area;
    const Mask thin = asked & first.without_area, other_thin = asked & second.without_area & first.with_area;
    Decision found{0, 0, 0};
    if (flat != 0) join(found, of_triangles_in_plane(first, b, flat));
    if ((thin | other_thin) != 0) {
      InSpace without[] = {a[0], a[1], a[2]}, other[] = {b[0], b[1], b[2]};
      for (std::size_t i = 0; i < 3; ++i)
        without[i] = chosen(other_thin, b[i], without[i]), other[i] = chosen(other_thin, a[i], other[i]);
      const Span span(without);
      join(found, of_segment(span.least, span.greatest, other, thin | other_thin));
    }
    return found;
  }

  /// Neither is in the plane of the other.
  static Decision across(const InSpace* a, const InSpace* b, const Corners& of_a, const Corners& of_b, Mask open) {
    const CloseTip p(a, of_a.at), q(b, of_b.at);
    const Way to_tip(q.corner, p.corner), ends[] = {Way(q.others[0], p.corner), Way(q.others[1], p.corner)};
    Mask before = 0, after = 0, together = 0, known = open;
    for (const InSpace& end : p.others) {
      const CloseNormal normal(Way(end, p.corner), to_tip);
      for (const Way& other_end : ends) {
        const Signs order = normal.along(other_end, open);
        before |= order.negative, after |= order.positive, together |= order.zero, known &= order.known();
      }
    }
    const Mask cross = before & after, in_a_point = p.on_plane | q.on_plane;
    return {known, (cross & in_a_point) | (together & ~cross), cross & ~in_a_point};
  }
};

#else

struct CloseSegmentTriangle;
struct CloseRayTriangle;
struct CloseTriangleTriangle;

#endif

}  // namespace
}  // namespace touchstone::robust::batch::isa
