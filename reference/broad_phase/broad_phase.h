// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "geometry/commands.h"
#include "reference/broad_phase/all_pairs.h"

namespace touchstone::reference {

/// A point is a box without extent.
template <class Real>
Aabb3<Real> box_of(const Point3<Real>& point) {
  return {point, point};
}

/// The first parameter at which a ray is in a box, by slabs: on each axis the ray is between both ends from one
/// quotient to the other, and in the box from the last of the first ones to the first of the last ones. On an axis on
/// which it stays where it is, it is between them or never.
template <class Real>
std::optional<Real> first_parameter(const Ray3<Real>& ray, const Aabb3<Real>& box) {
  const auto& [o, d] = ray;
  Real first(0);
  std::optional<Real> last;
  bool between = true;
  const auto cut = [&](const Real& origin, const Real& direction, const Real& low, const Real& high) {
    if (direction == Real(0)) {
      between = between && low <= origin && origin <= high;
      return;
    }
    Real enter = Real((low - origin) / direction), leave = Real((high - origin) / direction);
    if (leave < enter) std::swap(enter, leave);
    if (first < enter) first = enter;
    if (!last || leave < *last) last = leave;
  };
  cut(o.x, d.x, box.min.x, box.max.x), cut(o.y, d.y, box.min.y, box.max.y), cut(o.z, d.z, box.min.z, box.max.z);
  if (between && (!last || first <= *last)) return first;
  return std::nullopt;
}

/// Bodies in the order in which a ray meets them; inserted by their index, so that ties stay in its order.
template <class Real>
class OrderAlongRay {
 public:
  explicit OrderAlongRay(const Ray3<Real>& ray) : ray_(ray) {}

  void insert(Index body, const Aabb3<Real>& box) {
    const std::optional<Real> first = first_parameter(ray_, box);
    if (!first) return;
    std::size_t place = met_.size();
    while (place > 0 && *first < met_[place - 1].first) --place;
    met_.insert(met_.begin() + static_cast<std::ptrdiff_t>(place), {*first, body});
  }
  std::vector<Index> bodies() const {
    std::vector<Index> bodies;
    for (const auto& [first, body] : met_) bodies.push_back(body);
    return bodies;
  }

 private:
  const Ray3<Real>& ray_;
  std::vector<std::pair<Real, Index>> met_;
};

/// Each body against each other one, and against each query.
template <class Real>
class PairLoop {
 public:
  Index insert(const Aabb3<Real>& box) {
    boxes_.push_back(box);
    return static_cast<Index>(boxes_.size() - 1);
  }
  void move(Index body, const Aabb3<Real>& box) { boxes_[body] = box; }
  void remove(Index body) { boxes_[body].reset(); }

  std::vector<IndexPair> pairs() const {
    std::vector<IndexPair> pairs;
    for (Index i = 0; i < boxes_.size(); ++i) {
      for (Index j = i + 1; j < boxes_.size(); ++j) {
        if (boxes_[i] && boxes_[j] && pair_meets(*boxes_[i], *boxes_[j])) pairs.push_back({i, j});
      }
    }
    return pairs;
  }
  std::vector<Index> in_box(const Aabb3<Real>& box) const {
    std::vector<Index> bodies;
    for (Index i = 0; i < boxes_.size(); ++i)
      if (boxes_[i] && pair_meets(*boxes_[i], box)) bodies.push_back(i);
    return bodies;
  }
  std::vector<Index> at_point(const Point3<Real>& point) const { return in_box(box_of(point)); }
  std::vector<Index> along_ray(const Ray3<Real>& ray) const {
    OrderAlongRay<Real> order(ray);
    for (Index i = 0; i < boxes_.size(); ++i)
      if (boxes_[i]) order.insert(i, *boxes_[i]);
    return order.bodies();
  }

 private:
  std::vector<std::optional<Aabb3<Real>>> boxes_;  ///< by index; empty if a body was removed
};

template <class Real>
struct IndexedBox {
  Index index;
  Aabb3<Real> box;
};
template <class Real>
using IndexedBoxes = std::vector<IndexedBox<Real>>;

/// The query of a search in a structure.
template <class Real>
struct BoxQuery {
  Aabb3<Real> box;
  bool meets(const Aabb3<Real>& other) const { return pair_meets(box, other); }
};
template <class Real>
struct RayQuery {
  Ray3<Real> ray;
  bool meets(const Aabb3<Real>& box) const { return first_parameter(ray, box).has_value(); }
};

/// Bodies in a structure, which is made of those that are there when something is asked. `Structure<Real>(bodies)` has
/// `search(query, found, see)`, which calls found(body) for those that the query may meet, perhaps more than once, and
/// see(node, entered) for each node that it visits (`Unseen`, where it is left out).
template <template <class> class Structure, class Real>
class InStructure {
 public:
  Index insert(const Aabb3<Real>& box) {
    boxes_.push_back(box);
    return static_cast<Index>(boxes_.size() - 1);
  }
  void move(Index body, const Aabb3<Real>& box) { boxes_[body] = box; }
  void remove(Index body) { boxes_[body].reset(); }

  std::vector<IndexPair> pairs() const {
    const Structure<Real> structure(there());
    std::vector<IndexPair> pairs;
    for (const auto& [i, box] : there())
      for (const Index j : met(structure, BoxQuery<Real>{box}))
        if (i < j) pairs.push_back({i, j});
    return pairs;
  }
  std::vector<Index> in_box(const Aabb3<Real>& box) const {
    const std::set<Index> bodies = met(Structure<Real>(there()), BoxQuery<Real>{box});
    return {bodies.begin(), bodies.end()};
  }
  std::vector<Index> at_point(const Point3<Real>& point) const { return in_box(box_of(point)); }
  std::vector<Index> along_ray(const Ray3<Real>& ray) const {
    OrderAlongRay<Real> order(ray);
    for (const Index body : met(Structure<Real>(there()), RayQuery<Real>{ray})) order.insert(body, *boxes_[body]);
    return order.bodies();
  }

 private:
  IndexedBoxes<Real> there() const {
    IndexedBoxes<Real> bodies;
    for (Index i = 0; i < boxes_.size(); ++i)
      if (boxes_[i]) bodies.push_back({i, *boxes_[i]});
    return bodies;
  }
  template <class Query>
  static std::set<Index> met(const Structure<Real>& structure, const Query& query) {
    std::set<Index> met;
    structure.search(query, [&](const IndexedBox<Real>& body) {
      if (query.meets(body.box)) met.insert(body.index);
    });
    return met;
  }

  std::vector<std::optional<Aabb3<Real>>> boxes_;  ///< by index; empty if a body was removed
};

template <class Real>
Aabb3<Real> around(const IndexedBoxes<Real>& bodies) {
  Aabb3<Real> box = bodies[0].box;
  for (const auto& [index, other] : bodies) {
    for (Real Point3<Real>::*axis : {&Point3<Real>::x, &Point3<Real>::y, &Point3<Real>::z}) {
      if (other.min.*axis < box.min.*axis) box.min.*axis = other.min.*axis;
      if (box.max.*axis < other.max.*axis) box.max.*axis = other.max.*axis;
    }
  }
  return box;
}

/// Finds which bodies meet each other, a box, a point or a ray while bodies are added, moved and removed: the broad
/// phase of a running simulation.
///
/// Deck p. 55-56: the loop over all pairs, n (n - 1) / 2 tests by intervals (p. 45-47) for each query; the other
/// queries, which no page asks, are n tests by the same intervals and, of a ray, by the parameters at which it is
/// between both ends on each axis (p. 9-11).
/// boxes: any unit of length, the same for all; they are the bodies 0, 1, 2 ... to start with.
/// commands: carried out in their order. `insert`, a box: one more body, whose index is the number of bodies that there
/// have been so far, removed ones included. `move`, the index of a body that is there, and its `box` from now on.
/// `remove`, the index of a body that is there; no other body gets it afterwards.
/// Queries are commands: `ask`, the word `pairs`; `in_box`, a box; `at_point`, a point; `along_ray`, a ray.
/// Answer: to each query, in order, of the bodies that are there: the `pairs` i < j that meet, sorted by i and then by
/// j; the `bodies` that meet the box, or hold the point, sorted; those that the ray meets, `in_order` of the first t at
/// which it does, and those of the same t by their indices. A ray that starts in a body meets it at t = 0.
/// Closed sets: what touches meets. A box may be flat, a point, equal to another one or inside it. No body at all, and
/// no command, are valid; no query has no reply. A component 0 or -0.0 of a direction is no special case.
/// NaN or infinity: refused by robust and oracle (field "boxes[i].min[k]", "commands[i].insert.max[k]",
/// "commands[i].box.min[k]", "commands[i].in_box.min[k]", "commands[i].at_point[k]", "commands[i].along_ray.origin[k]"
/// ...: "finite number"); so are min > max ("boxes[i].max[k]" ...: "min <= max"), a body that is not there, or not any
/// more ("commands[i].move", "commands[i].remove": "index of a body that is there"), and a ray without a direction
/// ("commands[i].along_ray.direction": "nonzero direction"). The rules of boxes first, in their order; then of
/// commands, in theirs, a command's body before its box.
///
/// In exact arithmetic the formula is always right. Boxes and points are compared and not computed with: there the
/// double version is right too. For a ray, in binary64 (to nearest, u = 2^-53), each parameter T carries the roundings
/// of a difference and a quotient: off by at most (2 + 3u) u |T| + 2^-1074, unless one overflows. So it is right of
/// every box whose last entry and first exit, and in the right order of every two whose first parameters, differ by
/// more than the sum of two such bounds.
template <class Real>
Replies broad_phase(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands) {
  return replies(PairLoop<Real>{}, boxes, commands);
}

}  // namespace touchstone::reference
