// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/commands.h"
#include "reference/broad_phase/all_pairs.h"

namespace touchstone::reference {

/// Each body against each other one, whenever the pairs are asked for.
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

 private:
  std::vector<std::optional<Aabb3<Real>>> boxes_;  ///< by index; empty where a body was removed
};

/// Which bodies meet while some come, move and go: the broad phase of a running simulation.
///
/// Deck p. 55-56: the loop over all pairs, n (n - 1) / 2 tests by intervals (p. 45-47) for each query.
/// boxes: any unit of length, the same for all; they are the bodies 0, 1, 2 ... to start with.
/// commands: carried out in their order. `insert`, a box: one more body, whose index is the number of bodies that there
/// have been so far, removed ones included. `move`, the index of a body that is there, and its `box` from now on.
/// `remove`, the index of a body that is there; no other body gets it afterwards. `ask`, the word `pairs`: a query.
/// Answer: to each query, in order, the pairs of bodies i < j that are there and meet, sorted by i and then by j.
/// Closed sets: boxes that touch meet. A box may be flat, a point, equal to another one or inside it. No body at all,
/// and no command, are valid; no query has no reply.
/// NaN or infinity: refused by robust and oracle (field "boxes[i].min[k]", "commands[i].insert.max[k]",
/// "commands[i].box.min[k]" ...: "finite number"); so are min > max ("boxes[i].max[k]" ...: "min <= max") and a body
/// that is not there, or not any more ("commands[i].move", "commands[i].remove": "index of a body that is there"). The
/// rules of boxes first, in their order; then of commands, in theirs, a command's body before its box.
///
/// Boxes are compared and not computed with: the double version is always right, as is the one in exact arithmetic.
template <class Real>
Replies broad_phase(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands) {
  return replies(PairLoop<Real>{}, boxes, commands);
}

}  // namespace touchstone::reference
