// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/close.h"
#include "robust/batch/isa/triangles.h"

/// Segments and triangles of one plane in space, as second stages decide them: by exact turns and comparisons, as seen
/// along an axis that does not lie in the plane. The decisions are those of robust/kernel/solids/flat_hulls.h.
namespace touchstone::robust::batch::isa {
namespace {

#ifdef TOUCHSTONE_SECOND_STAGE

/// The factor, for each lane, that brings its greatest number between 2^-180 and 2^240: 1 unless that is less than
/// 2^-120 or more than 2^240. The first factor, 2^620 or its reciprocal, leaves numbers between 2^-454 and 2^404, the
/// second is 2^300 or its reciprocal.
Lanes factor_of_axis(Lanes size) {
  const Lanes far = factor_of(size), nearer = size * far;
  return far * where_above(nearer, same(0x1p240), same(0x1p-300),
                           where_above(same(0x1p-120), nearer, same(0x1p300), same(1)));
}

/// Multiplies a number, and keeps the lanes in which that is exact for certain: where the product is normal, or 0 times
/// the factor.
void multiply(Lanes& number, Lanes factor, Mask& exact) {
  const Lanes product = number * factor;
  exact &= equal(number, same(0)) | not_below(magnitude(product), same(0x1p-1000));
  number = product;
}

/// The lanes in which all numbers are in the window of cubes.
template <std::size_t n>
Mask in_window_of_cubes(const Lanes* numbers) {
  Mask all = all_lanes;
  for (std::size_t k = 0; k < n; ++k) all &= in_window(numbers[k], 0x1p250);
  return all;
}

/// Multiplies points by one power of two along each axis, which changes no sign of a volume, of a turn along an axis or
/// of a difference of coordinates. Number k is the coordinate k % 3 of a point. If there is a direction, it has the
/// last three numbers, goes with the space, and is multiplied by a power of two of its own besides. Returns the lanes
/// in which all products are exact and all numbers in the window of cubes.
template <std::size_t n>
Mask bring_axes_near_one(Lanes (&numbers)[n], bool direction = false) {
  const std::size_t points = direction ? n - 3 : n;
  Mask exact = all_lanes;
  const auto bring_direction = [&] {
    Lanes size = magnitude(numbers[n - 1]);
    for (std::size_t k = points; k < n; ++k) size = greater(size, magnitude(numbers[k]));
    for (std::size_t k = points; k < n; ++k) multiply(numbers[k], factor_of_axis(size), exact);
  };
  if (direction) bring_direction();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Lanes size = magnitude(numbers[axis]);
    for (std::size_t k = axis; k < points; k += 3) size = greater(size, magnitude(numbers[k]));
    if ((above(size, same(0x1p240)) | (above(same(0x1p-120), size) & above(size, same(0)))) == 0) continue;
    const Lanes factor = factor_of_axis(size);
    for (std::size_t k = axis; k < n; k += 3) multiply(numbers[k], factor, exact);
  }
  if (direction) bring_direction();
  return exact & in_window_of_cubes<n>(numbers);
}

/// A point as seen along an axis.
struct Seen {
  Lanes at[2];
};

/// Exact, of differences of numbers in the window.
Sides turn_of(const Difference& u, const Difference& w, const Difference& s, const Difference& t, Mask asked) {
  Sides turn = close_turn(u, w, s, t);
  if ((asked & ~turn.known()) != 0) settle(turn, u, w, s, t, asked);
  return turn;
}
Sides turn_of(const Seen& p, const Seen& q, const Seen& r, Mask asked) {
  return turn_of({q.at[0], p.at[0]}, {q.at[1], p.at[1]}, {r.at[1], p.at[1]}, {r.at[0], p.at[0]}, asked);
}

InSpace chosen(Mask here, const InSpace& p, const InSpace& q) {
  return {chosen(here, p.x, q.x), chosen(here, p.y, q.y), chosen(here, p.z, q.z)};
}

/// Sees the plane of three points along the first axis along which they certainly are a triangle with an area.
struct View {
  Mask with_area, without_area;  ///< the lanes in which it certainly has one, or none
  Mask along_x, along_y, clockwise;

  View(const InSpace& p, const InSpace& q, const InSpace& r, Mask asked) {
    const auto turn = [&](auto u, auto w) { return turn_of({{p.*u, p.*w}}, {{q.*u, q.*w}}, {{r.*u, r.*w}}, asked); };
    const Sides x = turn(&InSpace::y, &InSpace::z), y = turn(&InSpace::z, &InSpace::x),
                z = turn(&InSpace::x, &InSpace::y);
    along_x = x.left | x.right, along_y = ~along_x & (y.left | y.right);
    with_area = along_x | along_y | z.left | z.right, without_area = x.on & y.on & z.on;
    clockwise = (along_x & x.right) | (along_y & y.right) | (~(along_x | along_y) & z.right);
  }

  Seen seen(const InSpace& p) const {
    return {{chosen(along_x, p.y, chosen(along_y, p.z, p.x)), chosen(along_x, p.z, chosen(along_y, p.x, p.y))}};
  }
};

struct SeenTriangle : View {
  Seen corners[3];
  SeenTriangle(const InSpace* t, Mask asked)
      : View(t[0], t[1], t[2], asked), corners{seen(t[0]), seen(t[1]), seen(t[2])} {}
};

/// A part of a line, in the order of one coordinate; empty at first.
struct PartOfLine {
  Lanes least = same(0x1p1000), greatest = same(-0x1p1000);
  void add(Lanes place, Mask here) {
    least = chosen(here, lesser(least, place), least), greatest = chosen(here, greater(greatest, place), greatest);
  }
  /// The same from a place on: upwards, or downwards.
  PartOfLine beyond(Lanes place, Mask up) const {
    return {chosen(up, greater(least, place), least), chosen(up, greatest, lesser(greatest, place))};
  }
  Mask point() const { return equal(least, greatest); }
  Mask longer() const { return above(greatest, least); }
};

/// The common part of two hulls of one plane, from the lines of their edges, one after another: if the line of an edge
/// has its own hull on one side and nothing of the other, they have in common what both have on that line.
class CommonPart {
 public:
  Mask known, point = 0, segment = 0, decided = 0;

  explicit CommonPart(Mask asked) : known(asked), asked_(asked) {}

  /// The edge from one point to another has its own hull on the left, or on the right where that is `clockwise`; a
  /// segment, which has no other points, has it on both.
  ///
  /// Points of the line are in order by their first coordinates or, if those of the edge are equal, by the second ones.
  template <std::size_t n>
  void look(const Seen& from, const Seen& to, Mask clockwise, Mask both, const Seen (&others)[n]) {
    const Mask open = asked_ & ~decided, upright = equal(from.at[0], to.at[0]);
    const auto place = [upright](const Seen& p) { return chosen(upright, p.at[1], p.at[0]); };
    PartOfLine touching;
    Mask left = 0, right = 0, all_known = all_lanes;
    for (const Seen& other : others) {
      const Sides side = turn_of(from, to, other, open);
      left |= side.left, right |= side.right, all_known &= side.known();
      touching.add(place(other), side.on);
    }
    const Mask with_own = (clockwise & right) | (~clockwise & left);
    const Mask with_none = (clockwise & left) | (~clockwise & right);
    const Mask ends = open & all_known & (~with_own | (both & ~with_none));
    const Lanes first = greater(touching.least, lesser(place(from), place(to)));
    const Lanes last = lesser(touching.greatest, greater(place(from), place(to)));
    point |= ends & equal(first, last), segment |= ends & above(last, first), decided |= ends;
    known &= all_known | decided;
  }

 private:
  Mask asked_;
};

/// A segment in the plane of a triangle that has an area. If no edge tells, the segment reaches inside.
Decision of_segment_in_plane(const InSpace& p, const InSpace& q, const SeenTriangle& triangle, Mask asked) {
  const auto& corners = triangle.corners;
  const Seen ends[] = {triangle.seen(p), triangle.seen(q)};
  const Mask is_point = equal(p.x, q.x) & equal(p.y, q.y) & equal(p.z, q.z);
  CommonPart common(asked);
  for (std::size_t i = 0; i < 3; ++i) common.look(corners[i], corners[(i + 1) % 3], triangle.clockwise, 0, ends);
  CommonPart beside(common.known & ~(common.decided | is_point));
  beside.look(ends[0], ends[1], 0, all_lanes, corners);
  const Mask known = common.known & (common.decided | is_point | beside.known);
  const Mask inside = known & ~(common.decided | beside.decided);
  const Mask point = common.point | beside.point, segment = common.segment | beside.segment;
  return {known, point | (inside & is_point), segment | (inside & ~is_point)};
}

/// A ray in the plane of a triangle that has an area. If the line of an edge has the triangle on one side and nothing
/// of the ray, the ray touches the triangle on that line, or not at all. Otherwise the ray's line passes through the
/// triangle, which the ray then reaches, or touches it.
Decision of_ray_in_plane(const InSpace& from, const InSpace& direction, const SeenTriangle& triangle, Mask asked) {
  const auto& corners = triangle.corners;
  const Seen origin = triangle.seen(from), way = triangle.seen(direction);
  const Difference u(way.at[0], same(0)), w(way.at[1], same(0));
  const auto up_along = [&](Mask upright) { return above(chosen(upright, way.at[1], way.at[0]), same(0)); };
  Mask known = asked, decided = 0, point = 0, segment = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Seen &a = corners[i], &b = corners[(i + 1) % 3];
    const Mask open = known & ~decided, upright = equal(a.at[0], b.at[0]);
    const Sides at_origin = turn_of(a, b, origin, open);
    const Sides rise = turn_of({b.at[0], a.at[0]}, {b.at[1], a.at[1]}, w, u, open);
    const Mask all_known = at_origin.known() & rise.known(), right = triangle.clockwise;
    const Mask inwards = (~right & (at_origin.left | rise.left)) | (right & (at_origin.right | rise.right));
    const auto place = [upright](const Seen& p) { return chosen(upright, p.at[1], p.at[0]); };
    PartOfLine edge;
    edge.add(place(a), all_lanes), edge.add(place(b), all_lanes);
    const PartOfLine ahead = edge.beyond(place(origin), up_along(upright));
    const Mask ends = open & all_known & ~inwards, touches = ends & at_origin.on;
    const Mask on_edge = not_below(place(origin), edge.least) & not_below(edge.greatest, place(origin));
    point |= touches & ((rise.on & ahead.point()) | (~rise.on & on_edge));
    segment |= touches & rise.on & ahead.longer();
    decided |= ends;
    known &= all_known | decided;
  }
  const Mask open = known & ~decided, upright = equal(way.at[0], same(0));
  Mask left = 0, right = 0, all_known = all_lanes;
  PartOfLine touched;  // a corner, or none
  for (const Seen& corner : corners) {
    const Sides side = turn_of(u, w, {corner.at[1], origin.at[1]}, {corner.at[0], origin.at[0]}, open);
    left |= side.left, right |= side.right, all_known &= side.known();
    touched.add(chosen(upright, corner.at[1], corner.at[0]), side.on);
  }
  const PartOfLine ahead = touched.beyond(chosen(upright, origin.at[1], origin.at[0]), up_along(upright));
  const Mask through = left & right;
  known &= all_known | decided;
  return {known, point | (open & ahead.point() & ~through), segment | (open & through)};
}

/// Triangles of one plane, both with an area. If no edge tells, an area is common to them.
Decision of_triangles_in_plane(const SeenTriangle& first, const InSpace* b, Mask asked) {
  const Seen others[] = {first.seen(b[0]), first.seen(b[1]), first.seen(b[2])};
  const Sides turn = turn_of(others[0], others[1], others[2], asked);
  CommonPart common(asked & (turn.left | turn.right));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    common.look(first.corners[i], first.corners[next], first.clockwise, 0, others);
    common.look(others[i], others[next], turn.right, 0, first.corners);
  }
  return {common.known, common.point, common.segment, common.known & ~common.decided};
}

/// Points of a line in the order of their coordinates, x first: the segment from the least to the greatest of three, or
/// of two.
struct Span {
  InSpace least, greatest;

  Span(const InSpace& p, const InSpace& q) : least(p), greatest(p) { add(q); }
  explicit Span(const InSpace* t) : Span(t[0], t[1]) { add(t[2]); }

  Mask is_point() const { return equal(least.x, greatest.x) & equal(least.y, greatest.y) & equal(least.z, greatest.z); }

  /// The common part of two on one line.
  Decision with(const Span& other, Mask asked) const {
    const InSpace from = chosen(before(least, other.least), other.least, least);
    const InSpace to = chosen(before(greatest, other.greatest), greatest, other.greatest);
    const Mask longer = before(from, to);
    return {asked, ~(longer | before(to, from)), longer};
  }

  /// The same with a ray on that line, from a point on upwards, or downwards.
  Decision with(const InSpace& origin, Mask up, Mask asked) const {
    const InSpace from = chosen(up & before(least, origin), origin, least);
    const InSpace to = chosen(~up & before(origin, greatest), origin, greatest);
    const Mask longer = before(from, to);
    return {asked, ~(longer | before(to, from)), longer};
  }

  Mask holds(const InSpace& p) const { return ~(before(p, least) | before(greatest, p)); }

  static Mask before(const InSpace& p, const InSpace& q) {
    return above(q.x, p.x) | (equal(p.x, q.x) & (above(q.y, p.y) | (equal(p.y, q.y) & above(q.z, p.z))));
  }

 private:
  void add(const InSpace& p) {
    const Mask lower = before(p, least), higher = before(greatest, p);
    least = chosen(lower, p, least), greatest = chosen(higher, p, greatest);
  }
};

/// Adds the rows that another decides.
void join(Decision& all, const Decision& other) {
  all.known |= other.known, all.one |= other.known & other.one, all.two |= other.known & other.two;
  all.three |= other.known & other.three;
}

/// A ray and a segment of one plane, which may be a point. Where the ray does not begin on the segment's line, it meets
/// the segment if it leads to that line and does not have both ends on one side. Where it does and leads away from that
/// line, they can only have the beginning in common.
Decision of_ray_and_segment_in_plane(const InSpace& origin, const InSpace& direction, const Span& s, Mask asked) {
  const Lanes zero = same(0);
  const View view(s.least, s.greatest, origin, asked);
  Decision found{0, 0, 0};
  const Mask off_line = asked & view.with_area, on_line = asked & view.without_area;
  if (off_line != 0) {
    const Seen way = view.seen(direction), from = view.seen(origin), p = view.seen(s.least), q = view.seen(s.greatest);
    const Difference u(way.at[0], zero), w(way.at[1], zero);
    const Sides rise = turn_of({q.at[0], p.at[0]}, {q.at[1], p.at[1]}, w, u, off_line);
    const Sides at_p = turn_of(u, w, {p.at[1], from.at[1]}, {p.at[0], from.at[0]}, off_line);
    const Sides at_q = turn_of(u, w, {q.at[1], from.at[1]}, {q.at[0], from.at[0]}, off_line);
    const Mask leads_there = (view.clockwise & rise.left) | (~view.clockwise & rise.right);
    const Mask passes = (at_p.left & at_q.left) | (at_p.right & at_q.right);
    join(found, {off_line & rise.known() & at_p.known() & at_q.known(), leads_there & ~passes, 0});
  }
  if (on_line != 0) {
    const Difference x(direction.x, zero), y(direction.y, zero), z(direction.z, zero);
    Mask along = on_line, known = on_line;
    const InSpace ends[] = {s.least, s.greatest};
    for (const InSpace& end : ends) {
      const Difference to_x(end.x, origin.x), to_y(end.y, origin.y), to_z(end.z, origin.z);
      const Sides turns[] = {turn_of(y, z, to_z, to_y, on_line), turn_of(z, x, to_x, to_z, on_line),
                             turn_of(x, y, to_y, to_x, on_line)};
      for (const Sides& turn : turns) along &= turn.on, known &= turn.known();
    }
    const InSpace nowhere(zero, zero, zero);
    join(found, s.with(origin, Span::before(nowhere, direction), known & along));
    join(found, {known & ~along, s.holds(origin), 0});
  }
  return found;
}

/// Two segments of one plane, each of which may be a point. They are on one line if the line of neither leaves
/// out an end of the other. If neither line has nothing of the other on one side, they cross in a point.
Decision of_segments_in_plane(const Span& a, const Span& b, Mask asked) {
  View view(a.least, a.greatest, b.least, asked);
  Mask on_line = view.without_area;
  const auto look_at = [&](const InSpace& p, const InSpace& q, const InSpace& r) {
    const Mask open = asked & ~view.with_area;
    if (open == 0) return;
    const View other(p, q, r, open);
    view.along_x = (view.along_x & ~open) | (other.along_x & open);
    view.along_y = (view.along_y & ~open) | (other.along_y & open);
    view.with_area |= other.with_area & open, on_line &= other.without_area;
  };
  look_at(a.least, a.greatest, b.greatest);
  look_at(b.least, b.greatest, a.least);
  look_at(b.least, b.greatest, a.greatest);
  on_line &= asked & ~view.with_area;
  Decision found{0, 0, 0};
  if (on_line != 0) found = a.with(b, on_line), found.one &= on_line, found.two &= on_line;
  const Mask open = asked & view.with_area;
  if (open == 0) return found;
  const Seen of_a[] = {view.seen(a.least), view.seen(a.greatest)}, of_b[] = {view.seen(b.least), view.seen(b.greatest)};
  CommonPart by_a(open & ~a.is_point()), by_b(open & ~b.is_point());
  by_a.look(of_a[0], of_a[1], 0, all_lanes, of_b);
  by_b.look(of_b[0], of_b[1], 0, all_lanes, of_a);
  const Mask decided = by_a.decided | by_b.decided;
  join(found, {decided, by_a.point | by_b.point, by_a.segment | by_b.segment});
  join(found, {by_a.known & by_b.known & ~decided, all_lanes, 0});
  return found;
}

#endif

}  // namespace
}  // namespace touchstone::robust::batch::isa
