// SPDX-License-Identifier: Apache-2.0
#include "simulate/gas/gas.h"

#include <algorithm>

namespace touchstone::simulate::gas {
namespace {

constexpr int most_cells = 64;  // along an axis

}  // namespace

std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

template <class Visit>
void Gas::each_near(std::size_t cube, const Visit& visit) const {
  const auto& [x, y, z] = places_[cube].cell;
  const auto from = [](int k) { return std::max(k - 1, 0); };
  const auto to = [&](int k) { return std::min(k + 1, cells_ - 1); };
  for (int i = from(x); i <= to(x); ++i)
    for (int j = from(y); j <= to(y); ++j)
      for (int k = from(z); k <= to(z); ++k)
        for (const std::size_t other : grid_[(static_cast<std::size_t>(i) * cells_ + j) * cells_ + k])
          if (other != cube) visit(other);
}

Gas::Gas(Int64 side, Int64 room, std::vector<Cube> cubes) : side_(side), room_(room), cubes_(std::move(cubes)) {
  begin();
}

void Gas::begin() {
  now_ = {};
  // Wider than a cube: cubes that touch are in equal or adjacent cells, even at an instant at which one crosses.
  width_ = std::max(side_ + 1, room_ / most_cells + 1);
  cells_ = static_cast<int>(room_ / width_) + 1;
  grid_.assign(static_cast<std::size_t>(cells_) * cells_ * cells_, {});
  places_.assign(cubes_.size(), {});
  events_ = {};
  for (std::size_t i = 0; i < cubes_.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const Int64 line = cubes_[i].line[axis];
      if (line < 0 || line > room_) throw GasError("a cube is not in the room");
      places_[i].cell[axis] = static_cast<int>(line / width_);
    }
    require_meeting(i);
    expect_near(i);  // of each pair, by the later one
    cell(places_[i].cell).push_back(i);
  }
}

void Gas::require_meeting(std::size_t cube) const {
  for (int axis = 0; axis < 3; ++axis) {
    const Int64 line = cubes_[cube].line[axis], v = cubes_[cube].velocity[axis];
    if ((line == 0 && v > 0) || (line == room_ && v < 0)) throw GasError("a cube touches a wall and leaves it");
  }
  each_near(cube, [&](std::size_t other) {
    Join join{cube, other, {}};
    if (joined(cube, other, join) && join.face != std::array<bool, 3>{} && approach(join, /*backwards=*/true))
      throw GasError("two cubes touch and part");
  });
}

std::vector<std::size_t>& Gas::cell(const std::array<int, 3>& at) {
  return grid_[(static_cast<std::size_t>(at[0]) * cells_ + at[1]) * cells_ + at[2]];
}

bool Gas::stale(const Event& event) const {
  return places_[event.first].stamp != event.first_stamp || places_[event.second].stamp != event.second_stamp;
}

void Gas::expect(Instant at, std::size_t first, std::size_t second, Kind kind, int axis) {
  events_.push({at, first, second, places_[first].stamp, places_[second].stamp, kind, axis});
}

void Gas::expect_near(std::size_t cube) {
  expect_alone(cube);
  each_near(cube, [&](std::size_t other) { expect_pair(cube, other); });
}

/// Schedules the next wall or border of a cell.
void Gas::expect_alone(std::size_t cube) {
  Instant first;
  int axis = -1;
  Kind kind = Kind::wall;
  for (int a = 0; a < 3; ++a) {
    const Int64 v = cubes_[cube].velocity[a], line = cubes_[cube].line[a];
    if (v == 0) continue;
    const Int64 border = width_ * (places_[cube].cell[a] + (v > 0 ? 1 : 0));
    const bool leaves = border <= 0 || border > room_;
    const Int64 target = !leaves ? border : v > 0 ? room_ : 0;
    const Instant at = v > 0 ? Instant{target - line, v} : Instant{line - target, -v};
    if (axis < 0 || at < first) first = at, axis = a, kind = leaves ? Kind::wall : Kind::crossing;
  }
  if (axis >= 0) expect(first, cube, cube, kind, axis);
}

/// Schedules the first time from now on at which the two would begin to overlap.
void Gas::expect_pair(std::size_t a, std::size_t b) {
  Instant enter{-1, 1}, leave{1, 1};
  bool moves = false;
  for (int axis = 0; axis < 3; ++axis) {
    Int64 apart = cubes_[b].line[axis] - cubes_[a].line[axis];
    Int64 speed = cubes_[b].velocity[axis] - cubes_[a].velocity[axis];
    if (speed == 0) {
      if (apart <= -side_ || apart >= side_) return;
      continue;
    }
    if (speed < 0) apart = -apart, speed = -speed;
    const Instant in{-side_ - apart, speed}, out{side_ - apart, speed};
    if (!moves || enter < in) enter = in;
    if (!moves || out < leave) leave = out;
    moves = true;
    if (!(enter < leave)) return;
  }
  if (moves && !(now_ < leave)) return;
  if (!moves || enter < now_) throw GasError("two cubes overlap");
  expect(enter, a, b, Kind::pair, 0);
}

void Gas::cross(const Event& event) {
  ++counts_.crossings;
  auto& at = places_[event.first].cell;
  auto& left = cell(at);
  left.erase(std::find(left.begin(), left.end(), event.first));
  at[event.axis] += cubes_[event.first].velocity[event.axis] > 0 ? 1 : -1;
  cell(at).push_back(event.first);
  expect_alone(event.first);
  // Earlier neighbours are already scheduled.
  const int fresh = at[event.axis] + (cubes_[event.first].velocity[event.axis] > 0 ? 1 : -1);
  each_near(event.first, [&](std::size_t other) {
    if (places_[other].cell[event.axis] == fresh) expect_pair(event.first, other);
  });
}

void Gas::run(Int64 until) {
  const Instant end{until, 1};
  std::vector<std::size_t> seeds;
  while (!events_.empty() && !(end < events_.top().at)) {
    now_ = events_.top().at;
    seeds.clear();
    while (!events_.empty() && events_.top().at == now_) {
      const Event event = events_.top();
      events_.pop();
      if (stale(event)) continue;
      if (event.kind == Kind::crossing) cross(event);
      else seeds.insert(seeds.end(), {event.first, event.second});
    }
    if (!seeds.empty()) respond(seeds);
  }
}

void Gas::reverse(Int64 at) {
  for (Cube& cube : cubes_) {
    for (int axis = 0; axis < 3; ++axis) {
      cube.line[axis] += cube.velocity[axis] * at;
      cube.velocity[axis] = -cube.velocity[axis];
    }
  }
  for (Wide& impulse : wall_impulse_) impulse = -impulse;
  begin();
}

Wide Gas::doubled_energy() const {
  Wide sum = 0;
  for (const Cube& cube : cubes_)
    for (const Int64 v : cube.velocity) sum += Wide(v) * v;
  return sum;
}

std::array<Wide, 3> Gas::momentum_with_walls() const {
  std::array<Wide, 3> sum = wall_impulse_;
  for (const Cube& cube : cubes_)
    for (int axis = 0; axis < 3; ++axis) sum[axis] += cube.velocity[axis];
  return sum;
}

std::uint64_t Gas::hash() const {
  std::uint64_t sum = 0;
  for (const Cube& cube : cubes_) {
    std::uint64_t hash = 0;
    for (const auto& three : {cube.line, cube.velocity})
      for (const Int64 x : three) hash = mixed(hash ^ static_cast<std::uint64_t>(x));
    sum += hash;
  }
  return sum;
}

void Gas::respond(const std::vector<std::size_t>& seeds) {
  std::vector<bool> seen(cubes_.size()), changed(cubes_.size());
  std::vector<std::size_t> touched;
  const std::size_t before = hits_ == nullptr ? 0 : hits_->size();
  for (const std::size_t seed : seeds) {
    if (seen[seed]) continue;
    const Part part = part_of(seed, seen);
    for (const Join& join : part.joins) counts_.pairs += approach(join);
    for (int axis = 0; axis < 3; ++axis) answer(part, axis, changed);
    if (hits_ != nullptr) add_hit(part, changed);
    touched.insert(touched.end(), part.cubes.begin(), part.cubes.end());
  }
  if (hits_ != nullptr)
    std::sort(hits_->begin() + static_cast<std::ptrdiff_t>(before), hits_->end(),
              [](const Hit& a, const Hit& b) { return a.cubes[0] < b.cubes[0]; });
  for (const std::size_t cube : touched) places_[cube].stamp += changed[cube];
  for (const std::size_t cube : touched)
    if (changed[cube]) expect_near(cube);
}

void Gas::add_hit(const Part& part, const std::vector<bool>& changed) {
  Hit hit{now_, part.cubes};
  std::sort(hit.cubes.begin(), hit.cubes.end());
  std::erase_if(hit.cubes, [&](std::size_t cube) { return !changed[cube]; });
  for (const std::size_t cube : hit.cubes) hit.velocities.push_back(cubes_[cube].velocity);
  if (!hit.cubes.empty()) hits_->push_back(std::move(hit));
}

Gas::Part Gas::part_of(std::size_t seed, std::vector<bool>& seen) const {
  Part part{{seed}, {}, true};
  seen[seed] = true;
  for (std::size_t at = 0; at < part.cubes.size(); ++at) {
    const std::size_t cube = part.cubes[at];
    each_near(cube, [&](std::size_t other) {
      Join join{cube, other, {}};
      if (!joined(cube, other, join)) return;
      if (cube < other) part.joins.push_back(join);
      part.faces_only = part.faces_only && join.face[0] + join.face[1] + join.face[2] == 1;
      if (!seen[other]) part.cubes.push_back(other);
      seen[other] = true;
    });
  }
  return part;
}

}  // namespace touchstone::simulate::gas
