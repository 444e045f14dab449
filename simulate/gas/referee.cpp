// SPDX-License-Identifier: Apache-2.0
#include "simulate/gas/referee.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::simulate::gas {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Metres and seconds of the scene for engines. A second is the time in which the fastest cube flies its own side.
double metres(const GasScene& gas, Int64 line) { return static_cast<double>(line) / static_cast<double>(gas.side); }
double unit_of_speed(const GasScene& gas) { return static_cast<double>(std::max<Int64>(gas.speed, 1)); }
double seconds(const GasScene& gas, const Instant& at) {
  return static_cast<double>(at.p) / static_cast<double>(at.q) * unit_of_speed(gas) / static_cast<double>(gas.side);
}

std::array<double, 3> in_units(const GasScene& gas, const Vector3d& v) {
  const double unit = unit_of_speed(gas);
  return {v.x * unit, v.y * unit, v.z * unit};
}

bool reads_as(const std::array<double, 3>& seen, const std::array<Int64, 3>& velocity) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::nearbyint(seen[axis]) != static_cast<double>(velocity[axis])) return false;
  return true;
}

/// Follows one cube of the engine through its velocities in the gas.
class Follower {
 public:
  Follower(const std::vector<Record::Turn>& turns, const std::vector<Hit>& hits) : turns_(turns), hits_(hits) {}

  /// The hit after those that it may have answered at most; none if the gas has no more for it.
  std::size_t next() const { return reached_.back() + 1 < turns_.size() ? turns_[reached_.back() + 1].hit : none; }

  /// Reads a velocity at the end of a step; returns false if no sequence of the gas explains it. `apart`: the time
  /// between two hits that one reading may skip.
  bool read(const GasScene& gas, const std::array<double, 3>& seen, double now, double apart, double& latest) {
    std::vector<std::size_t> reached;
    for (const std::size_t from : reached_) {
      for (std::size_t to = from; to < turns_.size(); ++to) {
        if (to > from + 1 && at(gas, to) - at(gas, from + 1) >= apart) break;
        if (!reads_as(seen, turns_[to].velocity)) continue;
        if (std::find(reached.begin(), reached.end(), to) == reached.end()) reached.push_back(to);
      }
    }
    if (reached.empty()) return false;
    std::sort(reached.begin(), reached.end());
    if (reached.back() > reached_.back()) latest = std::max(latest, now - at(gas, reached.back()));
    reached_ = std::move(reached);
    return true;
  }

  /// True if its velocity is still that before the next hit.
  bool waits(const std::array<double, 3>& seen) const { return reads_as(seen, turns_[reached_.back()].velocity); }

 private:
  double at(const GasScene& gas, std::size_t turn) const { return seconds(gas, hits_[turns_[turn].hit].at); }

  const std::vector<Record::Turn>& turns_;
  const std::vector<Hit>& hits_;
  std::vector<std::size_t> reached_{0};  ///< possible counts of its hits answered by now
};

class Game {
 public:
  Game(const GasScene& gas, Verdict& verdict)
      : gas_(gas),
        record_(gas, 2 * gas.until),
        step_length_(1.0 / gas.steps_per_second),
        end_(seconds(gas, {gas.until, 1})),
        verdict_(verdict) {
    for (const Hit& hit : record_.hits()) verdict.hits += !(Instant{gas.until, 1} < hit.at);
    for (std::size_t cube = 0; cube < gas.cubes.size(); ++cube)
      followers_.emplace_back(record_.turns(cube), record_.hits());
  }

  /// Twice the time of the gas.
  std::uint64_t steps() const { return static_cast<std::uint64_t>(std::ceil(2 * end_ / step_length_)); }

  /// Returns false when no later step can change the verdict.
  bool goes_on(const State<double>& state, std::uint64_t step) {
    const double now = static_cast<double>(step) * step_length_;
    verdict_.steps = step;
    for (std::size_t cube = 0; cube < followers_.size(); ++cube) {
      if (gone_[cube]) continue;
      const auto seen = in_units(gas_, state[cube].velocity);
      double latest = verdict_.latest * step_length_;
      if (followers_[cube].read(gas_, seen, now, 2 * step_length_, latest)) {
        if (!verdict_.wrong) verdict_.latest = latest / step_length_;
        continue;
      }
      gone_[cube] = true;
      const auto& hits = record_.hits();
      const auto past =
          std::find_if(hits.begin(), hits.end(), [&](const Hit& hit) { return seconds(gas_, hit.at) > now; });
      const auto between = static_cast<std::size_t>(past - hits.begin());
      wrong_at({std::min(followers_[cube].next(), between), cube, step, seen, false});
    }
    return awaited() < (verdict_.wrong ? verdict_.wrong->hit : verdict_.hits);
  }

  /// The engine makes no more steps: unanswered hits are missed.
  void end(const State<double>& state) {
    for (std::size_t cube = 0; cube < followers_.size(); ++cube) {
      if (gone_[cube]) continue;
      wrong_at({followers_[cube].next(), cube, verdict_.steps, in_units(gas_, state[cube].velocity), true});
    }
  }

 private:
  void wrong_at(const WrongHit& wrong) {
    if (wrong.hit >= verdict_.hits) return;
    if (!verdict_.wrong || wrong.hit < verdict_.wrong->hit) verdict_.wrong = wrong;
  }
  /// The first hit that a cube has yet to answer.
  std::size_t awaited() const {
    std::size_t first = none;
    for (std::size_t cube = 0; cube < followers_.size(); ++cube)
      if (!gone_[cube]) first = std::min(first, followers_[cube].next());
    return first;
  }

  const GasScene& gas_;
  Record record_;
  double step_length_, end_;
  Verdict& verdict_;
  std::vector<Follower> followers_;
  std::vector<bool> gone_ = std::vector<bool>(gas_.cubes.size());
};

std::array<double, 3> in_doubles(const std::array<Int64, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
std::string three(const std::array<double, 3>& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]); }

}  // namespace

Scene scene_of(const GasScene& gas) {
  Scene scene;
  scene.title = gas.title;
  scene.settings.timestep = 1.0 / gas.steps_per_second;
  scene.settings.option = 2;
  const double size = metres(gas, gas.room + gas.side), low = gas.planar ? -size / 2 : 0;
  const auto add = [&](const char* axis, const Vector3d& up, double least) {
    scene.walls.push_back({std::string("room.min.") + axis, {up, -least}});
    scene.walls.push_back({std::string("room.max.") + axis, {{-up.x, -up.y, -up.z}, least + size}});
  };
  add("x", {1, 0, 0}, 0), add("y", {0, 1, 0}, 0), add("z", {0, 0, 1}, low);
  for (std::size_t i = 0; i < gas.cubes.size(); ++i) {
    const auto& [line, velocity] = gas.cubes[i];
    const auto middle = [&, &line = line](std::size_t axis) { return metres(gas, line[axis]) + 0.5; };
    const auto speed = [&, &velocity = velocity](std::size_t axis) {
      return static_cast<double>(velocity[axis]) / unit_of_speed(gas);
    };
    SceneBody body{.name = "cube_" + std::to_string(i), .shape = Shape::box, .half_extents = {0.5, 0.5, 0.5}};
    body.start = {{middle(0), middle(1), gas.planar ? 0 : middle(2)}, {speed(0), speed(1), speed(2)}};
    scene.bodies.push_back(body);
  }
  return scene;
}

Record::Record(const GasScene& scene, Int64 until) {
  Gas gas(scene.side, scene.room, scene.cubes);
  gas.record(hits_);
  gas.run(until);
  if (gas.scale() != 1) throw GasError("a group of cubes made the unit of length smaller: no referee for engines");
  for (const Cube& cube : scene.cubes) turns_.push_back({{none, cube.velocity}});
  for (std::size_t i = 0; i < hits_.size(); ++i)
    for (std::size_t k = 0; k < hits_[i].cubes.size(); ++k)
      turns_[hits_[i].cubes[k]].push_back({i, hits_[i].velocities[k]});
}

Verdict referee(const GasScene& gas, std::unique_ptr<EngineLines> lines, const std::string& command) {
  const Scene scene = scene_of(gas);
  Verdict verdict;
  Game game(gas, verdict);
  const auto run = engine_run(std::move(lines), command, scene, {});
  verdict.engine = run->name();
  verdict.ended = run->ended();
  verdict.unsupported = run->unsupported();
  if (!verdict.ended.empty()) return verdict;
  State<double> state = scene.start();
  for (std::uint64_t step = 1; step <= game.steps(); ++step) {
    try {
      state = run->own_step().state;
    } catch (const std::exception& failed) {
      verdict.ended = "step " + std::to_string(step) + ": " + failed.what();
      return verdict;
    }
    if (!game.goes_on(state, step)) break;
  }
  game.end(state);
  return verdict;
}

std::string sentence_of(const GasScene& gas, const Verdict& verdict) {
  if (!verdict.wrong)
    return verdict.engine + ": " +
           (verdict.ended.empty() ? fmt::format("answers all {} hits, at the latest {:.1f} steps after them",
                                                verdict.hits, verdict.latest)
                                  : verdict.ended);
  const Record record(gas, gas.until);
  const auto& [place, cube, step, velocity, missed] = *verdict.wrong;
  const Hit& hit = record.hits()[place];
  std::string colliding;
  for (const std::size_t one : hit.cubes) colliding += (colliding.empty() ? "" : " and ") + fmt::format("cube_{}", one);
  if (hit.cubes.size() == 1) colliding += " and a wall";
  std::string how =
      missed ? "which it does not answer" : fmt::format("in step {} cube_{} has {}", step, cube, three(velocity));
  const auto found = std::find(hit.cubes.begin(), hit.cubes.end(), cube);
  if (found == hit.cubes.end()) {
    how += ", which takes no part in that hit";
  } else {
    const auto& right = hit.velocities[static_cast<std::size_t>(found - hit.cubes.begin())];
    how += missed ? "" : " in place of " + three(in_doubles(right));
  }
  return fmt::format("{}: parts at hit {} of {}, {} at {:.4f} s: {}", verdict.engine, place + 1, verdict.hits,
                     colliding, seconds(gas, hit.at), how);
}

}  // namespace touchstone::simulate::gas
