// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "reference/broad_phase/broad_phase.h"

namespace touchstone::reference {

/// The sides of a plane that a shape reaches.
struct Sides {
  bool front, back;
};

/// A box: by E = N . p + d of the corners that are farthest in front and farthest behind.
template <class Real>
Sides sides(const Plane<Real>& plane, const Aabb3<Real>& box) {
  Real least = plane.offset, most = plane.offset;
  const auto add = [&](const Real& normal, const Real& low, const Real& high) {
    const bool forwards = Real(0) < normal;
    most = Real(most + normal * (forwards ? high : low));
    least = Real(least + normal * (forwards ? low : high));
  };
  add(plane.normal.x, box.min.x, box.max.x), add(plane.normal.y, box.min.y, box.max.y);
  add(plane.normal.z, box.min.z, box.max.z);
  return {most >= Real(0), least <= Real(0)};
}
template <class Real>
Sides sides(const Plane<Real>& plane, const BoxQuery<Real>& query) {
  return sides(plane, query.box);
}
/// A ray: by E of its start, and whether E rises or falls along it.
template <class Real>
Sides sides(const Plane<Real>& plane, const RayQuery<Real>& query) {
  const auto& [o, d] = query.ray;
  const Vector3<Real>& n = plane.normal;
  const Real start = Real(n.x * o.x + n.y * o.y + n.z * o.z + plane.offset), rise = dot(n, d);
  return {start >= Real(0) || rise > Real(0), start <= Real(0) || rise < Real(0)};
}

/// A plane halfway between the middles of two bodies, and the bodies in front and behind; a body on both sides is in
/// both parts. A leaf if that separates no bodies.
template <class Real>
class PlaneTree {
 public:
  explicit PlaneTree(IndexedBoxes<Real> bodies) {
    if (bodies.size() > 1) plane_ = between(bodies.front().box, bodies.back().box);
    IndexedBoxes<Real> front, back;
    for (const IndexedBox<Real>& body : bodies) {
      const Sides at = sides(plane_, body.box);
      if (at.front) front.push_back(body);
      if (at.back) back.push_back(body);
    }
    if (front.size() >= bodies.size() || back.size() >= bodies.size()) {
      bodies_ = std::move(bodies);
      return;
    }
    parts_.push_back(PlaneTree(std::move(front)));
    parts_.push_back(PlaneTree(std::move(back)));
  }

  template <class Query, class Found, class See = Unseen>
  void search(const Query& query, const Found& found, const See& see = {}) const {
    see(*this, true);
    for (const IndexedBox<Real>& body : bodies_) found(body);
    if (parts_.empty()) return;
    const Sides at = sides(plane_, query);
    if (at.front) parts_[0].search(query, found, see);
    if (at.back) parts_[1].search(query, found, see);
  }
  const Plane<Real>& plane() const { return plane_; }             ///< which cuts it, unless it is a leaf
  const std::vector<PlaneTree>& parts() const { return parts_; }  ///< in front of the plane and behind it; a leaf: none

 private:
  /// The plane through the midpoint of both middles, with the displacement from one to the other as its normal.
  static Plane<Real> between(const Aabb3<Real>& a, const Aabb3<Real>& b) {
    const auto middle = [](const Aabb3<Real>& box) {
      return Point3<Real>{Real((box.min.x + box.max.x) / Real(2)), Real((box.min.y + box.max.y) / Real(2)),
                          Real((box.min.z + box.max.z) / Real(2))};
    };
    const Point3<Real> p = middle(a), q = middle(b), m = middle({p, q});
    const Vector3<Real> normal = q - p;
    return {normal, Real(-(normal.x * m.x + normal.y * m.y + normal.z * m.z))};
  }

  Plane<Real> plane_{{Real(0), Real(0), Real(0)}, Real(0)};
  IndexedBoxes<Real> bodies_;
  std::vector<PlaneTree> parts_;
};

/// Answers `broad_phase` by a tree of planes that partition space.
///
/// Deck p. 63: what is in front of a plane does not meet what is behind it. The deck's planes are those of polygons;
/// bodies have none, so each plane is halfway between two of them (p. 20-21: E = N . p + d). Input, answer and
/// refusals: reference/broad_phase/broad_phase.h.
///
/// Right in exact arithmetic. In binary64 a body and a query that touch on a plane, or near it, may round to different
/// sides of it, and a body whose E is NaN is on neither: then it is lost (cause: rounding).
template <class Real>
Replies bsp_tree(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands) {
  return replies(InStructure<PlaneTree, Real>{}, boxes, commands);
}

}  // namespace touchstone::reference
