// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/polygon_polygon.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/lines/orientation.h"
#include "robust/polygons/point_in_polygon.h"
#include "robust/prepared/polygon.h"
#include "robust/rings/before.h"
#include "robust/rings/simple.h"

namespace touchstone::robust {
namespace {

// Two simple polygons have a common interior point exactly if one of these holds, since the boundaries are connected:
//   - two edges cross in the interior of both;
//   - in a vertex of one that lies on the boundary of the other, the two angles (open cones of interior points near the
//   vertex) overlap;
//   - the boundaries have no common point, and a vertex of one lies inside the other.
// For if a boundary runs inside the other polygon and the boundaries meet somewhere, then it leaves some common point
// towards that inside, and next to it lie interior points of both. So every decision is a turn of three input vertices:
// no point is ever constructed.
class Meeting {
 public:
  Meeting(const SimplePolygon& a, const SimplePolygon& b)
      : prepared_a_(a), prepared_b_(b), a_(a.ring()), b_(b.ring()) {}

  Decided<Contact> decided() {
    const Contact found = contact();
    return {found, latest_};
  }

 private:
  Contact contact() {
    bool touch = false;
    using structures::PlaneBox, structures::RingTree;
    const auto overlap = [&](const RingTree::Part& p, const RingTree::Part& q, const PlaneBox& around_q) {
      for (std::size_t i = p.first; i < p.last; ++i) {
        if (!PlaneBox::around(a_.previous(i)).with(PlaneBox::around(a_[i])).meets(around_q)) continue;
        for (std::size_t j = q.first; j < q.last; ++j) {
          if (apart(a_.previous(i), a_[i], b_.previous(j), b_[j])) continue;
          const Contact found = edges(edge_to(a_, i), edge_to(b_, j));
          if (found == Contact::overlapping) return true;
          touch = touch || found == Contact::touching;
        }
      }
      return false;
    };
    if (prepared_a_.tree().any_pair(prepared_b_.tree(), overlap)) return Contact::overlapping;
    if (touch) return Contact::touching;
    return inside(a_[0], prepared_b_) || inside(b_[0], prepared_a_) ? Contact::overlapping : Contact::disjoint;
  }

  static std::size_t edge_to(const Polygon2d& ring, std::size_t i) { return i == 0 ? ring.size() - 1 : i - 1; }

  int turn(const Point2d& p, const Point2d& q, const Point2d& r) {
    return 1 - static_cast<int>(stages::orientation::ask(p, q, r).noting(latest_));
  }

  static bool apart(const Point2d& p, const Point2d& q, const Point2d& r, const Point2d& s) {
    return std::max(p.x, q.x) < std::min(r.x, s.x) || std::max(r.x, s.x) < std::min(p.x, q.x) ||
           std::max(p.y, q.y) < std::min(r.y, s.y) || std::max(r.y, s.y) < std::min(p.y, q.y);
  }

  /// p lies on the line of q and r.
  static bool between(const Point2d& q, const Point2d& p, const Point2d& r) {
    return !before(p, std::min(q, r, before)) && !before(std::max(q, r, before), p);
  }

  /// The contact of edge i of a and edge j of b, as far as they determine it: contacts in vertices are decided by the
  /// edges that start there.
  Contact edges(std::size_t i, std::size_t j) {
    const Point2d &p = a_[i], &q = a_.next(i), &r = b_[j], &s = b_.next(j);
    const int pr = turn(p, q, r), ps = turn(p, q, s);
    if (pr * ps > 0) return Contact::disjoint;
    const int rp = turn(r, s, p), rq = turn(r, s, q);
    if (rp * rq > 0) return Contact::disjoint;
    if (pr * ps < 0 && rp * rq < 0) return Contact::overlapping;
    // An end of one lies on the other, because their boxes meet.
    const bool p_overlaps = rp == 0 && between(r, p, s) && cones_overlap(p, angle_of(a_, i), angle_at(b_, j, p));
    const bool r_overlaps = pr == 0 && between(p, r, q) && cones_overlap(r, angle_of(b_, j), angle_at(a_, i, r));
    return p_overlaps || r_overlaps ? Contact::overlapping : Contact::touching;
  }

  /// The interior near an apex: counter-clockwise from the direction of `from` to that of `to`.
  struct Angle {
    Point2d from, to;
  };
  static Angle angle_of(const Polygon2d& ring, std::size_t i) { return {ring.next(i), ring.previous(i)}; }
  /// p lies on edge i, possibly at one of its ends.
  static Angle angle_at(const Polygon2d& ring, std::size_t i, const Point2d& p) {
    if (p == ring[i]) return angle_of(ring, i);
    const std::size_t end = i + 1 == ring.size() ? 0 : i + 1;
    if (p == ring[end]) return angle_of(ring, end);
    return {ring[end], ring[i]};
  }

  bool same_direction(const Point2d& apex, const Point2d& p, const Point2d& q) {
    return turn(apex, p, q) == 0 && before(apex, p) == before(apex, q);
  }

  /// p lies in the half-open cone of the angle: towards `from` or inside.
  bool in_cone(const Point2d& apex, const Angle& angle, const Point2d& p) {
    if (same_direction(apex, angle.from, p)) return true;
    const int opening = turn(apex, angle.from, angle.to);
    if (opening > 0) return turn(apex, angle.from, p) > 0 && turn(apex, p, angle.to) > 0;
    if (same_direction(apex, angle.to, p)) return false;
    return !(turn(apex, angle.to, p) > 0 && turn(apex, p, angle.from) > 0);
  }

  /// Two open arcs overlap exactly if one of them begins inside the other or at its beginning.
  bool cones_overlap(const Point2d& apex, const Angle& one, const Angle& other) {
    return in_cone(apex, other, one.from) || in_cone(apex, one, other.from);
  }

  bool inside(const Point2d& p, const SimplePolygon& polygon) {
    return stages::point_in_polygon::of_prepared(polygon, p).noting(latest_) == Location::inside;
  }

  Stage latest_ = Stage::filter;
  const SimplePolygon &prepared_a_, &prepared_b_;
  const Polygon2d &a_, &b_;
};

void validate_simple(const char* field, const Polygon2d& polygon) {
  if (const auto defect = ring_defect(polygon)) validation::refuse(field, *defect, polygon.size());
}

}  // namespace

Decided<Contact> stages::polygon_polygon::ask(const Polygon2d& a, const Polygon2d& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  const validation::OpenRing open_a(a), open_b(b);
  validation::validate("a", a), validate_simple("a", *open_a);
  validation::validate("b", b), validate_simple("b", *open_b);
  return of_prepared({Validated{}, *open_a}, {Validated{}, *open_b});
}

Decided<Contact> stages::polygon_polygon::of_prepared(const SimplePolygon& a, const SimplePolygon& b) {
  const kernel::ControlWord ieee;  // coordinates are compared: flushed denormals would all be 0
  return Meeting(a, b).decided();
}

Contact polygon_polygon(const SimplePolygon& a, const SimplePolygon& b) {
  return stages::polygon_polygon::of_prepared(a, b).answer;
}

Contact polygon_polygon(const Polygon2d& a, const Polygon2d& b) { return stages::polygon_polygon::ask(a, b).answer; }

}  // namespace touchstone::robust
