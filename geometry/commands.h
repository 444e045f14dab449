// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/rays.h"
#include "geometry/volumes.h"

/// A question that is a program: bodies to start with, then commands, one after another. JSON: {"insert":box},
/// {"move":body,"box":box}, {"remove":body}; {"ask":"pairs"}, {"in_box":box}, {"at_point":point}, {"along_ray":ray}.
namespace touchstone {

/// One more body. Its index is the number of bodies that there have been before it.
template <class Real>
struct Insert {
  Aabb3<Real> box;
  static constexpr auto members = as_record("insert");
};
/// A body takes another place and size, and keeps its index. A body that is not there is refused.
template <class Real>
struct Move {
  Index body;
  Aabb3<Real> box;
  static constexpr auto members = as_record("move", "box");
};
/// Its index is not used again. A body that is not there is refused.
struct Remove {
  Index body;
  static constexpr auto members = as_record("remove");
};
/// pairs: which of the bodies that are there meet?
enum class Query { pairs };
constexpr auto words_of(Query) { return as_words("pairs"); }
struct Ask {
  Query query;
  static constexpr auto members = as_record("ask");
};
/// Which bodies meet this box?
template <class Real>
struct InBox {
  Aabb3<Real> box;
  static constexpr auto members = as_record("in_box");
};
/// In which bodies is this point?
template <class Real>
struct AtPoint {
  Point3<Real> point;
  static constexpr auto members = as_record("at_point");
};
/// Which bodies does this ray meet, one after another?
template <class Real>
struct AlongRay {
  Ray3<Real> ray;
  static constexpr auto members = as_record("along_ray");
};
template <class Real>
using Command = std::variant<Insert<Real>, Move<Real>, Remove, Ask, InBox<Real>, AtPoint<Real>, AlongRay<Real>>;

/// The reply to `pairs`: the pairs of bodies i < j, sorted.
struct PairsReply {
  std::vector<IndexPair> pairs;
  static constexpr auto members = as_record("pairs");
  friend bool operator==(const PairsReply&, const PairsReply&) = default;
};
/// To `in_box` and `at_point`: bodies, sorted.
struct BodiesReply {
  std::vector<Index> bodies;
  static constexpr auto members = as_record("bodies");
  friend bool operator==(const BodiesReply&, const BodiesReply&) = default;
};
/// The reply to `along_ray`: bodies in the order in which the ray meets them; of those that it meets at once, the
/// lesser index first. A list of the name `in_order` is judged with its order (catalogue/judge/compare.h).
struct RayReply {
  std::vector<Index> in_order;
  static constexpr auto members = as_record("in_order");
  friend bool operator==(const RayReply&, const RayReply&) = default;
};
using QueryReply = std::variant<PairsReply, BodiesReply, RayReply>;
using Replies = std::vector<QueryReply>;

using Insertd = Insert<double>;
using Moved = Move<double>;
using InBoxd = InBox<double>;
using AtPointd = AtPoint<double>;
using AlongRayd = AlongRay<double>;
using Commandd = Command<double>;

/// True if a command asks for a reply.
template <class Real>
bool is_query(const Command<Real>& command) {
  return command.index() >= 3;
}

/// A structure that keeps bodies and answers which of them meet each other, a box, a point or a ray. `move` and
/// `remove` name present bodies.
template <class Structure, class Real>
concept BroadPhase = requires(Structure structure, const Aabb3<Real>& box, Index body, const Point3<Real>& point,
                              const Ray3<Real>& ray) {
  { structure.insert(box) } -> std::convertible_to<Index>;
  structure.move(body, box);
  structure.remove(body);
  { structure.pairs() } -> std::convertible_to<std::vector<IndexPair>>;
  { structure.in_box(box) } -> std::convertible_to<std::vector<Index>>;
  { structure.at_point(point) } -> std::convertible_to<std::vector<Index>>;
  { structure.along_ray(ray) } -> std::convertible_to<std::vector<Index>>;
};

/// Has a structure carry out a program of valid commands. `after_each` sees it when the boxes are in it, and after
/// each command.
template <class Structure, class Real, class AfterEach>
requires BroadPhase<Structure, Real> Replies replies(Structure structure, const std::vector<Aabb3<Real>>& boxes,
                                                     const std::vector<Command<Real>>& commands,
                                                     const AfterEach& after_each) {
  Replies found;
  struct CarryOut {
    Structure& structure;
    Replies& found;
    void operator()(const Insert<Real>& command) const { structure.insert(command.box); }
    void operator()(const Move<Real>& command) const { structure.move(command.body, command.box); }
    void operator()(const Remove& command) const { structure.remove(command.body); }
    void operator()(const Ask&) const { found.push_back(PairsReply{structure.pairs()}); }
    void operator()(const InBox<Real>& query) const { found.push_back(BodiesReply{structure.in_box(query.box)}); }
    void operator()(const AtPoint<Real>& query) const { found.push_back(BodiesReply{structure.at_point(query.point)}); }
    void operator()(const AlongRay<Real>& query) const { found.push_back(RayReply{structure.along_ray(query.ray)}); }
  };
  for (const Aabb3<Real>& box : boxes) structure.insert(box);
  after_each(structure);
  for (const Command<Real>& command : commands) {
    std::visit(CarryOut{structure, found}, command);
    after_each(structure);
  }
  return found;
}
template <class Structure, class Real>
requires BroadPhase<Structure, Real> Replies replies(Structure structure, const std::vector<Aabb3<Real>>& boxes,
                                                     const std::vector<Command<Real>>& commands) {
  return replies(std::move(structure), boxes, commands, [](const Structure&) {});
}

}  // namespace touchstone
