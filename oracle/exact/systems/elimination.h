// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::oracle {

/// By comparisons alone, which are much faster for long integers: one segment is left of the other, or below it.
template <class Word>
bool boxes_apart(const Segment2<Word>& a, const Segment2<Word>& b) {
  const auto apart = [](const Word& p, const Word& q, const Word& r, const Word& s) {
    return (p < q ? q : p) < (r < s ? r : s) || (r < s ? s : r) < (p < q ? p : q);
  };
  return apart(a.a.x, a.b.x, b.a.x, b.b.x) || apart(a.a.y, a.b.y, b.a.y, b.b.y);
}

/// The relation of two closed segments on integers by elimination: Cramer's rule for a(ta) = b(tb) if the directions
/// differ, the order along the line if all four ends are collinear. No fraction is formed.
///
/// A second truth in addition to the linear program of segment_segment, and the fast one: for exhaustive runs.
/// Word holds the coordinates, Wide the products: with |coordinate| < 2^k, Word needs k + 2 bits and Wide 2k + 4
/// (std::int64_t for both up to k = 29; Word std::int64_t and Wide __int128 up to k = 61; GMP integers for the rest).
template <class Wide, class Word>
SegmentRelation segment_segment_relation(const Segment2<Word>& a, const Segment2<Word>& b) {
  const Word ux = a.b.x - a.a.x, uy = a.b.y - a.a.y;
  const Word vx = b.b.x - b.a.x, vy = b.b.y - b.a.y;
  const Word wx = b.a.x - a.a.x, wy = b.a.y - a.a.y;
  const Wide area = Wide(ux) * Wide(vy) - Wide(uy) * Wide(vx);
  const Wide ta = Wide(wx) * Wide(vy) - Wide(wy) * Wide(vx);
  const Wide tb = Wide(wx) * Wide(uy) - Wide(wy) * Wide(ux);
  const Wide zero(0);
  if (area > zero) {
    return ta >= zero && ta <= area && tb >= zero && tb <= area ? SegmentRelation::point : SegmentRelation::disjoint;
  }
  if (area < zero) {
    return ta <= zero && ta >= area && tb <= zero && tb >= area ? SegmentRelation::point : SegmentRelation::disjoint;
  }
  if (ta != zero || tb != zero) return SegmentRelation::disjoint;
  const auto before = [](const Point2<Word>& p, const Point2<Word>& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
  const bool a_turned = before(a.b, a.a), b_turned = before(b.b, b.a);
  const Point2<Word>&a_first = a_turned ? a.b : a.a, &a_last = a_turned ? a.a : a.b;
  const Point2<Word>&b_first = b_turned ? b.b : b.a, &b_last = b_turned ? b.a : b.b;
  const Point2<Word>& first = before(a_first, b_first) ? b_first : a_first;
  const Point2<Word>& last = before(a_last, b_last) ? a_last : b_last;
  if (before(last, first)) return SegmentRelation::disjoint;
  return before(first, last) ? SegmentRelation::overlap : SegmentRelation::point;
}

/// The side of p by elimination from the 3x3 determinant. Word and Wide as above.
template <class Wide, class Word>
Side orientation_side(const Point2<Word>& p0, const Point2<Word>& p1, const Point2<Word>& p) {
  const Word ux = p1.x - p0.x, uy = p1.y - p0.y;
  const Word wx = p.x - p0.x, wy = p.y - p0.y;
  const Wide left = Wide(ux) * Wide(wy), right = Wide(uy) * Wide(wx);
  return left > right ? Side::left : left < right ? Side::right : Side::on;
}

}  // namespace touchstone::oracle
