// SPDX-License-Identifier: Apache-2.0
#include "simulate/gas/gas_scene.h"

#include <fmt/format.h>

#include "catalogue/codec/expected.h"
#include "simulate/fields.h"

namespace touchstone::simulate::gas {
namespace {

constexpr std::uint32_t longest = 1u << 30;

Int64 integer(Fields& fields, const char* name, std::uint32_t least) {
  fields.at(name);
  const std::uint32_t value = fields.count_or(name, least, 0);
  if (value > longest)
    throw InvalidInput(fields.path_of(name), catalogue::expected("an integer up to 2^30", fields.at(name)));
  return value;
}

/// The integers from `low` to `high` that follow one another from a seed.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed) {}
  Int64 between(Int64 low, Int64 high) {
    return low + static_cast<Int64>(mixed(state_++) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

}  // namespace

bool is_gas(const catalogue::Json& json) { return json.is_object() && json.contains("gas"); }

GasScene read_gas(const catalogue::Json& json) {
  Fields fields(json, "");
  if (fields.number("touchstone_scene") != 1)
    throw InvalidInput("touchstone_scene", catalogue::expected("1", json["touchstone_scene"]));
  GasScene scene;
  scene.title = fields.text_or("title", "");
  scene.about = fields.text_or("about", "");
  fields.has("deck_pages");
  Fields gas(fields.at("gas"), "gas");
  fields.end();
  scene.side = integer(gas, "side", 1);
  scene.until = integer(gas, "until", 0);
  const Int64 along = integer(gas, "cubes_along", 1), gap = integer(gas, "gap", 2), speed = integer(gas, "speed", 0);
  scene.speed = speed;
  scene.planar = gas.flag_or("planar", false);
  scene.steps_per_second = gas.count_or("steps_per_second", 1, 60);
  Draws draws(static_cast<std::uint64_t>(integer(gas, "seed", 0)));
  gas.end();
  if (along > 64) throw InvalidInput("gas.cubes_along", catalogue::expected("up to 64", gas.at("cubes_along")));
  const Int64 spacing = scene.side + gap;
  scene.room = spacing * along - scene.side;
  const int axes = scene.planar ? 2 : 3;
  for (Int64 i = 0; i < along * along * (scene.planar ? 1 : along); ++i) {
    Cube cube;
    const Int64 place[]{i / (along * along), i / along % along, i % along};
    if (scene.planar) cube.line[2] = scene.room / 2;
    for (int axis = 0; axis < axes; ++axis) {
      cube.line[axis] = place[scene.planar ? axis + 1 : axis] * spacing + draws.between(1, gap - 1);
      cube.velocity[axis] = draws.between(-speed, speed);
    }
    scene.cubes.push_back(cube);
  }
  return scene;
}

bool run_gas(const GasScene& scene, std::ostream& out) {
  Gas gas(scene.side, scene.room, scene.cubes);
  const auto energy = gas.doubled_energy();
  const auto momentum = gas.momentum_with_walls();
  const std::uint64_t start = gas.hash();
  gas.run(scene.until);
  const Wide unit = gas.scale();
  const auto now = gas.momentum_with_walls();
  const bool same_energy = gas.doubled_energy() == energy * unit * unit;
  const bool same_momentum =
      now[0] == momentum[0] * unit && now[1] == momentum[1] * unit && now[2] == momentum[2] * unit;
  const Counts forwards = gas.counts();
  const std::uint64_t there = gas.hash();
  gas.reverse(scene.until);
  gas.run(scene.until);
  gas.reverse(scene.until);
  bool same_bits = gas.cubes().size() == scene.cubes.size();
  for (std::size_t i = 0; same_bits && i < scene.cubes.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      same_bits = same_bits && gas.cubes()[i].line[axis] == scene.cubes[i].line[axis] * gas.scale() &&
                  gas.cubes()[i].velocity[axis] == scene.cubes[i].velocity[axis] * gas.scale();
  const auto yes = [](bool kept) { return kept ? "identical" : "CHANGED"; };
  if (!scene.title.empty()) out << scene.title << '\n';
  out << fmt::format(
      "{} cubes, {} collisions of pairs, {} at walls, {} groups of three or more, {} crossings of cells\n"
      "energy               {}\nmomentum with walls  {}\nrun backwards        {} to the start\n"
      "hash at the start    {:016x}\nhash at the end      {:016x}\n",
      scene.cubes.size(), forwards.pairs, forwards.at_walls, forwards.groups, forwards.crossings, yes(same_energy),
      yes(same_momentum), yes(same_bits), start, there);
  return same_energy && same_momentum && same_bits;
}

}  // namespace touchstone::simulate::gas
