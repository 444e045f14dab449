// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "catalogue/families/box_draws.h"
#include "catalogue/families/draw_stream.h"
#include "geometry/commands.h"

/// Programs, drawn from a draw stream.
namespace touchstone::catalogue {

using Program = std::tuple<std::vector<Aabb3d>, std::vector<Commandd>>;

/// A program that grows by one command after another and keeps account of the bodies that are there.
class Programming {
 public:
  explicit Programming(DrawStream& draws) : choices_(draws) {}

  void start_with(const Aabb3d& box) {
    boxes_.push_back(box);
    there_.push_back(next_++);
  }
  void insert(const Aabb3d& box) {
    commands_.push_back(Insertd{box});
    there_.push_back(next_++);
  }
  /// Of one of the bodies that are there; nothing where there is none.
  void move(const Aabb3d& box) {
    if (!there_.empty()) commands_.push_back(Moved{there_[choices_.below(there_.size())], box});
  }
  void remove() {
    if (there_.empty()) return;
    const auto place = there_.begin() + static_cast<std::ptrdiff_t>(choices_.below(there_.size()));
    commands_.push_back(Remove{*place});
    there_.erase(place);
  }
  void ask() { commands_.push_back(Ask{Query::pairs}); }

  /// Any of these; `box()` draws one.
  template <class Draw>
  void any(const Draw& box) {
    switch (choices_.below(4)) {
      case 0: return ask();
      case 1: return insert(box());
      case 2: return move(box());
      default: return remove();
    }
  }

  const std::vector<Index>& there() const { return there_; }
  Program program() const { return {boxes_, commands_}; }

 private:
  DrawStream& choices_;
  std::vector<Aabb3d> boxes_;
  std::vector<Commandd> commands_;
  std::vector<Index> there_;
  Index next_ = 0;
};

/// So many bodies to start with and so many commands at most, one after another ("one more?"), so that the draws of
/// one can be cut out and leave the others as they are; a query at the end.
template <class Draw>
Program any_program(DrawStream& c, const Draw& box, std::size_t bodies, std::size_t commands) {
  Programming p(c);
  for (std::size_t left = bodies; left > 0 && c.below(bodies) != 0; --left) p.start_with(box(c));
  for (std::size_t left = commands; left > 0 && c.below(commands) != 0; --left) p.any([&] { return box(c); });
  p.ask();
  return p.program();
}

/// Bodies that are not there become some that are; without any, the command becomes a query. A program that asks
/// nothing asks at its end.
inline void repair_program(Program& program) {
  auto& [boxes, commands] = program;
  for (Aabb3d& box : boxes) put_in_order(box);
  std::vector<Index> there;
  Index next = 0;
  for (; next < boxes.size(); ++next) there.push_back(next);
  for (Commandd& command : commands) {
    if (auto* insert = std::get_if<Insertd>(&command)) {
      put_in_order(insert->box);
      there.push_back(next++);
      continue;
    }
    if (std::holds_alternative<Ask>(command)) continue;
    if (there.empty()) {
      command = Ask{Query::pairs};
    } else if (auto* move = std::get_if<Moved>(&command)) {
      move->body = there[move->body % there.size()];
      put_in_order(move->box);
    } else {
      Index& body = std::get<Remove>(command).body;
      const auto place = there.begin() + static_cast<std::ptrdiff_t>(body % there.size());
      body = *place;
      there.erase(place);
    }
  }
  const auto asks = [](const Commandd& command) { return std::holds_alternative<Ask>(command); };
  if (std::none_of(commands.begin(), commands.end(), asks)) commands.emplace_back(Ask{Query::pairs});
}

}  // namespace touchstone::catalogue
