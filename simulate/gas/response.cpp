// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include "simulate/gas/gas.h"

namespace touchstone::simulate::gas {
namespace {

/// Limits so that products of any two of them, and sums of a few, fit in 128 bits.
constexpr Wide longest_line = Wide(1) << 61, longest_velocity = Wide(1) << 30;

bool within(Wide x, Wide bound) { return -bound < x && x < bound; }

}  // namespace

Wide Gas::scaled_place(std::size_t cube, int axis) const {
  return Wide(cubes_[cube].line[axis]) * now_.q + Wide(cubes_[cube].velocity[axis]) * now_.p;
}

bool Gas::at_wall(std::size_t cube, int axis) const {
  const Wide place = scaled_place(cube, axis);
  return place == 0 || place == Wide(room_) * now_.q;
}

bool Gas::joined(std::size_t a, std::size_t b, Join& join) const {
  const Wide side = Wide(side_) * now_.q;
  for (int axis = 0; axis < 3; ++axis) {
    const Wide apart = scaled_place(b, axis) - scaled_place(a, axis);
    if (!within(apart, side + 1)) return false;
    join.face[axis] = !within(apart, side);
  }
  return true;
}

bool Gas::approach(const Join& join, bool backwards) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (!join.face[axis]) continue;
    const bool ahead = scaled_place(join.second, axis) > scaled_place(join.first, axis);
    const Int64 forwards = cubes_[join.second].velocity[axis] - cubes_[join.first].velocity[axis];
    const Int64 speed = backwards ? -forwards : forwards;
    if (ahead ? speed >= 0 : speed <= 0) return false;
  }
  return true;
}

void Gas::set(std::size_t cube, int axis, Wide line, Wide velocity) {
  if (!within(line, longest_line) || !within(velocity, longest_velocity))
    throw GasError("numbers became too long for 64 bits");
  cubes_[cube].line[axis] = static_cast<Int64>(line);
  cubes_[cube].velocity[axis] = static_cast<Int64>(velocity);
}

void Gas::rescale(Int64 factor) {
  const auto longer = [&](Int64 x) {
    if (!within(Wide(x) * factor, longest_line)) throw GasError("numbers became too long for 64 bits");
    return x * factor;
  };
  side_ = longer(side_), room_ = longer(room_), width_ = longer(width_), scale_ = longer(scale_);
  for (Wide& impulse : wall_impulse_) impulse *= factor;
  for (std::size_t i = 0; i < cubes_.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      set(i, axis, Wide(cubes_[i].line[axis]) * factor, Wide(cubes_[i].velocity[axis]) * factor);
}

/// Handles each group of cubes whose faces touch along the axis.
void Gas::answer(const Part& part, int axis, std::vector<bool>& changed) {
  std::vector<std::size_t> left = part.cubes;
  while (!left.empty()) {
    std::vector<std::size_t> group{left.back()};
    left.pop_back();
    bool row = part.faces_only;
    for (std::size_t at = 0; at < group.size(); ++at) {
      int ahead = 0, behind = 0;
      for (const Join& join : part.joins) {
        if (!join.face[axis] || (join.first != group[at] && join.second != group[at])) continue;
        const std::size_t other = join.first == group[at] ? join.second : join.first;
        (scaled_place(other, axis) > scaled_place(group[at], axis) ? ahead : behind)++;
        const auto found = std::find(left.begin(), left.end(), other);
        if (found == left.end()) continue;
        group.push_back(other);
        left.erase(found);
      }
      row = row && ahead <= 1 && behind <= 1;
    }
    answer_group(part, std::move(group), row, axis, changed);
  }
}

void Gas::answer_group(const Part& part, std::vector<std::size_t> group, bool row, int axis,
                       std::vector<bool>& changed) {
  const bool wall = std::any_of(group.begin(), group.end(), [&](std::size_t cube) { return at_wall(cube, axis); });
  if (group.size() == 1 && !wall) return;
  std::vector<Int64> before;
  for (const std::size_t cube : group) before.push_back(cubes_[cube].velocity[axis]);
  const Int64 unit = scale_;
  if (group.size() > 2) ++counts_.groups;
  if (wall) {
    counts_.at_walls += part.cubes.size() == 1;
    for (const std::size_t cube : group) {
      const Int64 v = cubes_[cube].velocity[axis];
      const Wide place = scaled_place(cube, axis) / now_.q;  // an integer: the wall, or a multiple of the side from it
      wall_impulse_[axis] += 2 * Wide(v);
      set(cube, axis, 2 * place - cubes_[cube].line[axis], -Wide(v));
    }
  } else if (row) {
    std::sort(group.begin(), group.end(),
              [&](std::size_t a, std::size_t b) { return scaled_place(a, axis) < scaled_place(b, axis); });
    before.clear();
    for (const std::size_t cube : group) before.push_back(cubes_[cube].velocity[axis]);
    for (std::size_t k = 0, last = group.size() - 1; k < last; ++k, --last) {
      const Cube a = cubes_[group[k]], b = cubes_[group[last]];
      const Wide between = Wide(last - k) * side_;
      set(group[k], axis, b.line[axis] - between, b.velocity[axis]);
      set(group[last], axis, a.line[axis] + between, a.velocity[axis]);
    }
  } else {
    counts_.mirrored += group.size() > 2;
    mirror(group, axis);
  }
  for (std::size_t k = 0; k < group.size(); ++k)
    if (Wide(before[k]) * (scale_ / unit) != cubes_[group[k]].velocity[axis]) changed[group[k]] = true;
}

/// Reflects every line about the mean of all, each relative to the position of the first: faces touch, so that
/// positions differ by multiples of the side.
void Gas::mirror(const std::vector<std::size_t>& group, int axis) {
  const Int64 many = static_cast<Int64>(group.size());
  const auto from_first = [&](std::size_t cube) {
    return (scaled_place(cube, axis) - scaled_place(group[0], axis)) / now_.q;
  };
  const auto doubled_sums = [&] {
    std::array<Wide, 2> sums{};
    for (const std::size_t cube : group)
      sums[0] += 2 * (cubes_[cube].line[axis] - from_first(cube)), sums[1] += 2 * Wide(cubes_[cube].velocity[axis]);
    return sums;
  };
  auto [lines, velocities] = doubled_sums();
  const Int64 common =
      std::gcd(many, std::gcd(static_cast<Int64>(lines % many), static_cast<Int64>(velocities % many)));
  if (common != many) {
    rescale(many / common);
    const auto sums = doubled_sums();
    lines = sums[0], velocities = sums[1];
  }
  std::vector<Wide> shifts;
  for (const std::size_t cube : group) shifts.push_back(from_first(cube));
  for (std::size_t k = 0; k < group.size(); ++k) {
    const Cube& cube = cubes_[group[k]];
    set(group[k], axis, lines / many + 2 * shifts[k] - cube.line[axis], velocities / many - cube.velocity[axis]);
  }
}

}  // namespace touchstone::simulate::gas
