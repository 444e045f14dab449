// SPDX-License-Identifier: Apache-2.0
#include "simulate/world/overlaps.h"

#include "simulate/world/world.h"

namespace touchstone::simulate {
namespace {

/// The contact in the log's form: all questions of `meet` are answered with a Contact or a side.
bool overlaps(const Json& answer) {
  const std::string word = answer.is_string() ? answer.get<std::string>() : answer["side"].get<std::string>();
  return word == "overlapping" || word == "back";
}

}  // namespace

std::optional<BrokenRule> overlap_at_start(const Scene& scene) {
  const World<Robust> world(scene);
  const State<double> start = scene.start();
  Nearby nearby;
  for (const Touch& touch : world.touches(start, start, nearby, BroadPhase::tree)) {
    Log log;
    if (!world.meet(touch, start, &log) || !overlaps(log[0].answer)) continue;
    const std::string& other = touch.wall ? scene.walls[touch.other].name : scene.bodies[touch.body].name;
    const std::size_t body = touch.wall ? touch.body : touch.other;
    return BrokenRule{"bodies[" + std::to_string(body) + "].position", "overlaps " + other + " at the start"};
  }
  return std::nullopt;
}

}  // namespace touchstone::simulate
