// SPDX-License-Identifier: Apache-2.0
#include "robust/rings/meeting.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "robust/lines/orientation.h"
#include "robust/rings/before.h"

namespace touchstone::robust {
namespace {

using structures::PlaneBox, structures::RingTree, structures::TreedRing;

// Where two boundaries meet, there are points inside both nearby exactly if one of these holds:
//   - two edges cross in the interior of both, and no other ring has a vertex there;
//   - in a vertex of one that lies on the boundary of the other, the angles of all rings there (open cones of interior
//   points near the vertex) have a common direction.
// For an edge to each side of which something lies inside one area, and which crosses an edge of the other, crosses
// from outside to inside. Holes that touch an edge from inside in its crossing with another may have nothing common
// left there. So every decision is a turn of three input vertices: no point is ever constructed.
class Meeting {
 public:
  Meeting(Rings a, Rings b, CommonEdge common) : a_(a), b_(b), common_(common) {}

  Decided<Contact> decided() {
    const Contact found = contact();
    return {found, latest_};
  }

 private:
  Contact contact() {
    bool touch = false;
    for (const TreedRing* const a : a_) {
      for (const TreedRing* const b : b_) {
        if (overlap(*a, *b, touch)) return Contact::overlapping;
      }
    }
    return touch ? Contact::touching : Contact::disjoint;
  }

  bool overlap(const TreedRing& one, const TreedRing& other, bool& touch) {
    const Polygon2d &a = one.ring, &b = other.ring;
    const auto overlap = [&](const RingTree::Part& p, const RingTree::Part& q, const PlaneBox& around_q) {
      for (std::size_t i = p.first; i < p.last; ++i) {
        if (!PlaneBox::around(a.previous(i)).with(PlaneBox::around(a[i])).meets(around_q)) continue;
        for (std::size_t j = q.first; j < q.last; ++j) {
          if (apart(a.previous(i), a[i], b.previous(j), b[j])) continue;
          const Contact found = edges(a, edge_to(a, i), b, edge_to(b, j));
          if (found == Contact::overlapping) return true;
          touch = touch || found == Contact::touching;
        }
      }
      return false;
    };
    return one.tree.any_pair(other.tree, overlap);
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

  /// The contact of edge i of a ring of a and edge j of one of b, as far as they determine it: contacts in vertices are
  /// decided by the edges that start there.
  Contact edges(const Polygon2d& a, std::size_t i, const Polygon2d& b, std::size_t j) {
    const Point2d &p = a[i], &q = a.next(i), &r = b[j], &s = b.next(j);
    const int pr = turn(p, q, r), ps = turn(p, q, s);
    if (pr * ps > 0) return Contact::disjoint;
    const int rp = turn(r, s, p), rq = turn(r, s, q);
    if (rp * rq > 0) return Contact::disjoint;
    if (pr * ps < 0 && rp * rq < 0) return vertex_of_a_at(p, q, r, s) ? Contact::touching : Contact::overlapping;
    if (common_ == CommonEdge::overlaps && pr == 0 && ps == 0 &&
        before(std::max(std::min(p, q, before), std::min(r, s, before), before),
               std::min(std::max(p, q, before), std::max(r, s, before), before)))
      return Contact::overlapping;
    // An end of one lies on the other, because their boxes meet.
    const bool p_overlaps = rp == 0 && between(r, p, s) && cones_overlap(p, a, angle_of(a, i), b, angle_at(b, j, p));
    const bool r_overlaps = pr == 0 && between(p, r, q) && cones_overlap(r, a, angle_at(a, i, r), b, angle_of(b, j));
    return p_overlaps || r_overlaps ? Contact::overlapping : Contact::touching;
  }

  /// A ring of a has a vertex where two edges cross.
  bool vertex_of_a_at(const Point2d& p, const Point2d& q, const Point2d& r, const Point2d& s) {
    const auto at_crossing = [&](const Point2d& v) {
      return !apart(p, q, v, v) && turn(p, q, v) == 0 && turn(r, s, v) == 0;
    };
    return a_.size() > 1 && std::any_of(a_.begin(), a_.end(), [&](const TreedRing* ring) {
      return std::any_of(ring->ring.vertices.begin(), ring->ring.vertices.end(), at_crossing);
    });
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

  /// Adds the angle of a ring at p, if it passes there.
  void add_angle(std::vector<Angle>& angles, const Polygon2d& ring, const Point2d& p) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!apart(ring[i], ring.next(i), p, p) && turn(ring[i], ring.next(i), p) == 0)
        return angles.push_back(angle_at(ring, i, p));
    }
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

  /// The angles of two rings, and those of all others that pass the apex, have a common direction exactly if one of
  /// them begins within all others.
  bool cones_overlap(const Point2d& apex, const Polygon2d& one, const Angle& of_one, const Polygon2d& other,
                     const Angle& of_other) {
    if (!in_cone(apex, of_other, of_one.from) && !in_cone(apex, of_one, of_other.from)) return false;
    if (a_.size() + b_.size() == 2) return true;
    std::vector<Angle> angles{of_one, of_other};
    for (const Rings& rings : {a_, b_}) {
      for (const TreedRing* const ring : rings)
        if (&ring->ring != &one && &ring->ring != &other) add_angle(angles, ring->ring, apex);
    }
    return std::any_of(angles.begin(), angles.end(), [&](const Angle& first) {
      return std::all_of(angles.begin(), angles.end(),
                         [&](const Angle& angle) { return in_cone(apex, angle, first.from); });
    });
  }

  Stage latest_ = Stage::filter;
  const Rings a_, b_;
  const CommonEdge common_;
};

}  // namespace

Decided<Contact> contact_of_boundaries(Rings a, Rings b, CommonEdge common) { return Meeting(a, b, common).decided(); }

Location located_by_turns(const TreedRing& treed, const Point2d& p) {
  const Polygon2d& ring = treed.ring;
  return treed.tree.located(ring, p, [&](const RingTree::Part& part) {
    bool odd = false;
    for (std::size_t i = part.first; i < part.last; ++i) {
      const Point2d &a = ring.previous(i), &b = ring[i];
      const Side side = orientation(a, b, p);
      if (side == Side::on && p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
          p.y <= std::max(a.y, b.y))
        return Location::boundary;
      odd ^= (a.y > p.y) != (b.y > p.y) && (side == Side::left) == (b.y > p.y);
    }
    return odd ? Location::inside : Location::outside;
  });
}

}  // namespace touchstone::robust
