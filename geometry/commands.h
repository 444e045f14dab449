// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/volumes.h"

/// A question that is a program: bodies to start with, then commands, one after another.
namespace touchstone {

/// One more body. Its index is the number of bodies that there have been before it.
template <class Real>
struct Insert {
  Aabb3<Real> box;
};
/// A body takes another place and size, and keeps its index. A body that is not there is refused.
template <class Real>
struct Move {
  Index body;
  Aabb3<Real> box;
};
/// Its index is not used again. A body that is not there is refused.
struct Remove {
  Index body;
};
/// pairs: which of the bodies that are there meet?
enum class Query { pairs };
struct Ask {
  Query query;
};
template <class Real>
using Command = std::variant<Insert<Real>, Move<Real>, Remove, Ask>;

/// What is answered to a query: the pairs of bodies i < j, sorted.
struct PairsReply {
  std::vector<IndexPair> pairs;
  friend bool operator==(const PairsReply&, const PairsReply&) = default;
};
using Replies = std::vector<PairsReply>;

using Insertd = Insert<double>;
using Moved = Move<double>;
using Commandd = Command<double>;

/// What keeps bodies and tells which of them meet. `move` and `remove` are asked of bodies that are there.
template <class Structure, class Real>
concept BroadPhase = requires(Structure structure, const Aabb3<Real>& box, Index body) {
  { structure.insert(box) } -> std::convertible_to<Index>;
  structure.move(body, box);
  structure.remove(body);
  { structure.pairs() } -> std::convertible_to<std::vector<IndexPair>>;
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
    void operator()(const Ask&) const { found.push_back({structure.pairs()}); }
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
