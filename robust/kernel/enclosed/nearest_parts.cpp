// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/enclosed/nearest_parts.h"

namespace touchstone::robust::filters {
namespace {

/// The position of n / d, d > 0, relative to 0 and 1.
enum class Within { unknown, start, end, between };

template <class N, class D>
Within within(const N& n, const D& d) {
  if (n.not_positive()) return Within::start;
  const auto rest = d - n;
  if (rest.not_positive()) return Within::end;
  return n.positive() && rest.positive() ? Within::between : Within::unknown;
}

Part part_of(const Segment3d& s, Within where) {
  if (where == Within::unknown) return {};
  if (where == Within::between) return Part::edge(s.a, s.b);
  return Part::corner(where == Within::start ? s.a : s.b);
}

}  // namespace

Parts nearest_parts(const Segment3d& a, const Point3d& p) {
  const auto v = sized_between(a.a, a.b), q = sized_between(a.a, p);
  return {part_of(a, within(dot(q, v), dot(v, v))), Part::corner(p)};
}

/// Decides for each edge, e, with f to the third corner, whether p is nearest to the edge's start or to its interior,
/// or is on the inner side of it.
Parts nearest_parts(const Triangle3d& a, const Point3d& p) {
  const std::array corners{a.a, a.b, a.c, a.a, a.b};
  int inner = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3d &from = corners[k], &to = corners[k + 1], &third = corners[k + 2];
    const auto e = sized_between(from, to), f = sized_between(from, third), q = sized_between(from, p);
    const auto along = dot(e, q), other = dot(f, q);
    if (along.not_positive() && other.not_positive()) return {Part::corner(from), Part::corner(p)};
    const auto length = dot(e, e);
    const auto inwards = other * length - along * dot(e, f);
    if (inwards.not_positive() && within(along, length) == Within::between)
      return {Part::edge(from, to), Part::corner(p)};
    inner += inwards.positive();
  }
  if (inner < 3) return {};
  return {Part::face(a), Part::corner(p)};
}

Parts nearest_parts(const Segment3d& a, const Segment3d& b) {
  const auto v = sized_between(a.a, a.b), w = sized_between(b.a, b.b), r = sized_between(b.a, a.a);
  const auto vv = dot(v, v), ww = dot(w, w), vw = dot(v, w), vr = dot(v, r), wr = dot(w, r), rv = -vr;
  // For points of a at t on b, seen from a's start or end: half the slope along a, times ww if t is between 0 and 1.
  const auto across = vr * ww - wr * vw, square = vv * ww - vw * vw;
  const Within at_start = within(wr, ww);
  if (at_start == Within::start ? vr.not_negative()
      : at_start == Within::end ? (vr - vw).not_negative()
                                : at_start == Within::between && across.not_negative())
    return {Part::corner(a.a), part_of(b, at_start)};
  const Within at_end = within(wr + vw, ww);
  if (at_end == Within::start ? (vr + vv).negative()
      : at_end == Within::end ? (vr + vv - vw).negative()
                              : at_end == Within::between && (across + square).negative())
    return {Part::corner(a.b), part_of(b, at_end)};
  const auto along = wr * vv - vr * vw;
  if (along.negative() && within(rv, vv) == Within::between) return {Part::edge(a.a, a.b), Part::corner(b.a)};
  if ((along - square).positive() && within(vw - vr, vv) == Within::between)
    return {Part::edge(a.a, a.b), Part::corner(b.b)};
  if (!square.positive() || within(-across, square) != Within::between || within(along, square) != Within::between)
    return {};
  return {Part::edge(a.a, a.b), Part::edge(b.a, b.b)};
}

}  // namespace touchstone::robust::filters
