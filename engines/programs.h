// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <touchstone/geometry/commands.h>
#include <touchstone/robust/structures/along_ray.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

/// What wrappers of foreign broad phases share: what a program asks for, and the order along a ray.
namespace touchstone::programs {

/// Whether a program has a command of that kind.
template <class Kind, class Real>
bool has(const std::vector<Command<Real>>& commands) {
  return std::any_of(commands.begin(), commands.end(),
                     [](const Command<Real>& command) { return std::holds_alternative<Kind>(command); });
}

/// Whether that holds of every box of a program, of queries too.
template <class Real, class Holds>
bool all_boxes(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands, const Holds& holds) {
  return std::all_of(boxes.begin(), boxes.end(), holds) &&
         std::all_of(commands.begin(), commands.end(), [&holds](const Command<Real>& command) {
           if (const auto* insert = std::get_if<Insert<Real>>(&command)) return holds(insert->box);
           if (const auto* move = std::get_if<Move<Real>>(&command)) return holds(move->box);
           if (const auto* query = std::get_if<InBox<Real>>(&command)) return holds(query->box);
           if (const auto* query = std::get_if<AtPoint<Real>>(&command))
             return holds(Aabb3<Real>{query->point, query->point});
           return true;
         });
}

/// A library that lists what a ray meets promises no order: what it lists is put into the right one, exactly, so that
/// only what it leaves out is judged. What the ray does not meet comes last.
template <class Real>
std::vector<Index> in_order(const Ray3<Real>& ray, const std::vector<Index>& listed,
                            const std::vector<Aabb3<Real>>& boxes) {
  const auto point = [](const auto& p) { return Point3d{p.x, p.y, p.z}; };
  const Ray3d exact{point(ray.origin), {ray.direction.x, ray.direction.y, ray.direction.z}};
  const robust::kernel::ControlWord control;
  std::vector<std::pair<robust::structures::Moment, Index>> met;
  std::vector<Index> beside;
  for (const Index body : listed) {
    const auto moment = robust::structures::first_moment(exact, {point(boxes[body].min), point(boxes[body].max)});
    if (moment) met.emplace_back(*moment, body);
    else beside.push_back(body);
  }
  std::vector<Index> bodies = robust::structures::in_order(std::move(met));
  bodies.insert(bodies.end(), beside.begin(), beside.end());
  return bodies;
}

}  // namespace touchstone::programs
