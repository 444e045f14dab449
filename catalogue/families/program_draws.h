// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "catalogue/families/box_draws.h"
#include "catalogue/families/triangle_draws.h"
#include "geometry/commands.h"

/// Programs, drawn from a draw stream.
namespace touchstone::catalogue {

using Program = std::tuple<std::vector<Aabb3d>, std::vector<Commandd>>;

/// Calls `see` at each query with the boxes by index, empty where a body was removed, and the query. Returns the boxes
/// at the end.
template <class See>
std::vector<std::optional<Aabb3d>> each_query(const Program& program, const See& see) {
  const auto& [start, commands] = program;
  std::vector<std::optional<Aabb3d>> boxes(start.begin(), start.end());
  for (const Commandd& command : commands) {
    if (const auto* insert = std::get_if<Insertd>(&command)) boxes.emplace_back(insert->box);
    else if (const auto* move = std::get_if<Moved>(&command)) boxes[move->body] = move->box;
    else if (const auto* remove = std::get_if<Remove>(&command)) boxes[remove->body].reset();
    else see(boxes, command);
  }
  return boxes;
}

/// A direction is not zero.
inline Ray3d repaired(Ray3d ray) {
  Vector3d& v = ray.direction;
  if (v.x == 0 && v.y == 0 && v.z == 0) v.x = 1;
  return ray;
}

/// From a corner of one box towards a corner of another; or along an axis, forwards or backwards, or along a face, with
/// zeros of both signs.
inline Ray3d ray_between(const Aabb3d& a, const Aabb3d& b, DrawStream& c) {
  const Point3d from = c.coin() ? a.max : a.min, to = c.coin() ? b.min : b.max;
  Ray3d ray{from, to - from};
  auto& [x, y, z] = ray.direction;
  for (double* component : {&x, &y, &z}) {
    switch (c.below(5)) {
      case 0: *component = 0; break;
      case 1: *component = -0.0; break;
      default: break;
    }
  }
  return repaired(ray);
}

/// A program that grows by one command after another and keeps account of the bodies that are there.
class Programming {
 public:
  explicit Programming(DrawStream& draws) : draws_(draws) {}

  void start_with(const Aabb3d& box) {
    boxes_.push_back(box);
    there_.push_back(next_++);
  }
  template <class Draw>
  void start_with(std::size_t bodies, const Draw& box) {
    while (boxes_.size() < bodies) start_with(box(draws_));
  }
  void insert(const Aabb3d& box) {
    commands_.push_back(Insertd{box});
    there_.push_back(next_++);
  }
  /// Moves one of the present bodies; does nothing if there is none.
  void move(const Aabb3d& box) {
    if (!there_.empty()) commands_.push_back(Moved{there_[draws_.below(there_.size())], box});
  }
  void remove() {
    if (there_.empty()) return;
    const auto place = there_.begin() + static_cast<std::ptrdiff_t>(draws_.below(there_.size()));
    commands_.push_back(Remove{*place});
    there_.erase(place);
  }
  void ask() { commands_.push_back(Ask{Query::pairs}); }
  void ask_in(const Aabb3d& box) { commands_.push_back(InBoxd{box}); }
  void ask_at(const Point3d& point) { commands_.push_back(AtPointd{point}); }
  void ask_along(const Ray3d& ray) { commands_.push_back(AlongRayd{ray}); }

  /// Any query, of boxes as `box()` draws them, their corners, and rays between these.
  template <class Draw>
  void any_query(const Draw& box) {
    switch (draws_.below(4)) {
      case 0: return ask();
      case 1: return ask_in(box());
      case 2: {
        const Aabb3d at = box();
        return ask_at(draws_.coin() ? at.max : at.min);
      }
      default: {
        const Aabb3d from = box(), to = box();
        return ask_along(ray_between(from, to, draws_));
      }
    }
  }
  /// Any command.
  template <class Draw>
  void any(const Draw& box) {
    switch (draws_.below(4)) {
      case 0: return any_query(box);
      case 1: return insert(box());
      case 2: return move(box());
      default: return remove();
    }
  }

  const std::vector<Index>& there() const { return there_; }
  Program program() const { return {boxes_, commands_}; }

 private:
  DrawStream& draws_;
  std::vector<Aabb3d> boxes_;
  std::vector<Commandd> commands_;
  std::vector<Index> there_;
  Index next_ = 0;
};

/// Boxes of small integers, wider ones, and those of a lattice that touch.
inline Aabb3d small_box(DrawStream& c) {
  const Point3d p{small_integer(c, 4), small_integer(c, 4), small_integer(c, 4)};
  return {p, p + Vector3d{up_to(c, 3), up_to(c, 3), up_to(c, 3)}};
}
inline Aabb3d wide_box(DrawStream& c) {
  const Point3d p{integer(c, 6), integer(c, 6), integer(c, 3)};
  return {p, p + Vector3d{up_to(c, 11), up_to(c, 11), up_to(c, 11)}};
}
/// A cell of the lattice of unit boxes.
inline Aabb3d cell(DrawStream& c) {
  const Point3d p = small_lattice_point(c);
  return {p, p + Vector3d{1, 1, 1}};
}

/// So many bodies to start with and so many commands at most, one after another ("one more?"), so that the draws of
/// one can be cut out and leave the others as they are; a query at the end.
template <class Draw>
Program any_program(DrawStream& c, const Draw& box, std::size_t bodies, std::size_t commands) {
  Programming p(c);
  for (std::size_t left = bodies; left > 0 && c.below(bodies) != 0; --left) p.start_with(box(c));
  for (std::size_t left = commands; left > 0 && c.below(commands) != 0; --left) p.any([&] { return box(c); });
  p.any_query([&] { return box(c); });
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
    if (auto* query = std::get_if<InBoxd>(&command)) put_in_order(query->box);
    if (auto* query = std::get_if<AlongRayd>(&command)) query->ray = repaired(query->ray);
    if (is_query(command)) continue;
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
  if (std::none_of(commands.begin(), commands.end(), is_query<double>)) commands.emplace_back(Ask{Query::pairs});
}

}  // namespace touchstone::catalogue
