// SPDX-License-Identifier: Apache-2.0
#include "simulate/gas/gas.h"

#include <algorithm>
#include <sstream>

#include "proptests/catch.h"
#include "proptests/refusal.h"
#include "simulate/gas/gas_scene.h"

namespace touchstone::proptests::gas_tests {
namespace {

using simulate::gas::Cube;
using simulate::gas::Gas;
using simulate::gas::GasError;
using simulate::gas::Int64;

/// A cube on the x axis in a room so wide that no wall is met.
Cube on_x(Int64 line, Int64 velocity) { return {{line, 1000, 1000}, {velocity, 0, 0}}; }

std::vector<Int64> speeds(const Gas& gas) {
  std::vector<Int64> speeds;
  for (const Cube& cube : gas.cubes()) speeds.push_back(cube.velocity[0]);
  return speeds;
}

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed * 1000003) {}
  Int64 between(Int64 low, Int64 high) {
    return low + static_cast<Int64>(simulate::gas::mixed(state_++) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

constexpr Int64 side = 4, room = 16;

bool overlap(const Cube& a, const Cube& b, Int64 unit) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(a.line[axis] - b.line[axis]) >= side * unit) return false;
  return true;
}

/// Small numbers, so that many contacts fall on the same instant.
std::vector<Cube> crowded(std::uint64_t seed) {
  Draws draws(seed);
  std::vector<Cube> cubes;
  for (int tries = 0; tries < 40 && cubes.size() < 9; ++tries) {
    Cube cube;
    for (Int64& line : cube.line) line = draws.between(0, room / 2) * 2;
    for (Int64& velocity : cube.velocity) velocity = draws.between(-2, 2);
    cubes.push_back(cube);
    try {
      Gas(side, room, cubes);
    } catch (const GasError&) {
      cubes.pop_back();  // it overlaps another, or touches it and parts
    }
  }
  return cubes;
}

/// The cubes at that time, in units of `unit`; empty where numbers became too long.
std::vector<Cube> after(std::vector<Cube> cubes, Int64 time, Int64& unit, simulate::gas::Counts* counts = nullptr) {
  try {
    Gas gas(side, room, std::move(cubes));
    gas.run(time);
    if (counts != nullptr) *counts = gas.counts();
    unit = gas.scale();
    cubes = gas.cubes();
  } catch (const GasError& error) {
    REQUIRE(std::string(error.what()) == "numbers became too long for 64 bits");
    return {};
  }
  for (Cube& cube : cubes)
    for (int axis = 0; axis < 3; ++axis) cube.line[axis] += cube.velocity[axis] * time;
  return cubes;
}

constexpr std::uint64_t worlds = 400;
constexpr Int64 time = 12;

}  // namespace

TEST_CASE("gas: two cubes that meet exchange their velocities, a row hands them on, at a wall one turns") {
  Gas pair(10, 2000, {on_x(1, 3), on_x(41, -1)});
  pair.run(7);
  CHECK(speeds(pair) == std::vector<Int64>{3, -1});
  pair.run(8);  // they are 30 apart and come closer by 4: at 7 1/2
  CHECK(speeds(pair) == std::vector<Int64>{-1, 3});
  Gas row(10, 2000, {on_x(1, 5), on_x(50, 0), on_x(60, 0), on_x(70, 0)});
  row.run(8);
  CHECK(speeds(row) == std::vector<Int64>{0, 0, 0, 5});
  CHECK(row.counts().groups == 1);
  Gas wall(10, 2000, {on_x(20, -7)});
  wall.run(3);
  CHECK(speeds(wall) == std::vector<Int64>{7});
  CHECK(wall.cubes()[0].line[0] == -20);
  CHECK(wall.momentum_with_walls()[0] == -7);
}

TEST_CASE("gas: a cube that meets two side by side is reflected with them about their mean, in a smaller unit") {
  const auto beside = [](Int64 x, Int64 y) { return Cube{{x, y, 1000}, {0, 0, 0}}; };
  Gas gas(10, 2000, {on_x(1, 3), beside(50, 994), beside(50, 1006)});
  gas.run(14);  // they meet at 13
  CHECK(gas.counts().mirrored == 1);
  CHECK(speeds(gas) == std::vector<Int64>{-1, 2, 2});  // V = 1
  Gas uneven(10, 2000, {on_x(1, 4), beside(51, 994), beside(51, 1006)});
  uneven.run(11);
  CHECK(uneven.scale() == 3);
  CHECK(speeds(uneven) == std::vector<Int64>{-4, 8, 8});  // V = 4/3, velocities in thirds
}

TEST_CASE("gas: energy and momentum are identical, nothing overlaps, and backwards it returns to its first bits") {
  std::uint64_t groups = 0, mirrored = 0, done = 0;
  for (std::uint64_t seed = 1; seed <= worlds; ++seed) {
    INFO("world " << seed);
    const std::vector<Cube> start = crowded(seed);
    try {
      Gas gas(side, room, start);
      const auto energy = gas.doubled_energy();
      const auto momentum = gas.momentum_with_walls();
      gas.run(time);
      const simulate::gas::Wide unit = gas.scale();
      REQUIRE((gas.doubled_energy() == energy * unit * unit));
      for (int axis = 0; axis < 3; ++axis) REQUIRE((gas.momentum_with_walls()[axis] == momentum[axis] * unit));
      groups += gas.counts().groups, mirrored += gas.counts().mirrored;
      gas.reverse(time);
      for (std::size_t i = 0; i < start.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) REQUIRE(!overlap(gas.cubes()[i], gas.cubes()[j], gas.scale()));
      gas.run(time);
      gas.reverse(time);
      for (std::size_t i = 0; i < start.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
          REQUIRE(gas.cubes()[i].line[axis] == start[i].line[axis] * gas.scale());
          REQUIRE(gas.cubes()[i].velocity[axis] == start[i].velocity[axis] * gas.scale());
        }
      ++done;
    } catch (const GasError& error) {
      REQUIRE(std::string(error.what()) == "numbers became too long for 64 bits");
    }
  }
  CHECK(done > worlds * 9 / 10);
  CHECK(groups > 200);
  CHECK(mirrored > 50);
}

TEST_CASE("gas: cubes in another order, axes exchanged, one mirrored: the same gas") {
  for (std::uint64_t seed = 1; seed <= worlds / 2; ++seed) {
    INFO("world " << seed);
    const std::vector<Cube> start = crowded(seed);
    const auto changed = [](Cube cube, Int64 unit) {
      std::rotate(cube.line.begin(), cube.line.begin() + 1, cube.line.end());
      std::rotate(cube.velocity.begin(), cube.velocity.begin() + 1, cube.velocity.end());
      cube.line[0] = room * unit - cube.line[0];
      cube.velocity[0] = -cube.velocity[0];
      return cube;
    };
    std::vector<Cube> other;
    for (const Cube& cube : start) other.insert(other.begin(), changed(cube, 1));
    Int64 unit = 1, other_unit = 1;
    const std::vector<Cube> expected = after(start, time, unit), found = after(other, time, other_unit);
    REQUIRE(expected.size() == found.size());
    REQUIRE(unit == other_unit);
    for (std::size_t i = 0; i < expected.size(); ++i)
      REQUIRE(found[expected.size() - 1 - i] == changed(expected[i], unit));
  }
}

TEST_CASE("gas: cubes that overlap at the start, or leave the room, are refused") {
  const auto error_of = [](const std::vector<Cube>& cubes) -> std::string {
    try {
      Gas(10, 2000, cubes);
    } catch (const GasError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(error_of({on_x(0, 0), on_x(10, 0)}) == "");
  CHECK(error_of({on_x(0, 0), on_x(9, 0)}) == "two cubes overlap");
  CHECK(error_of({on_x(1, 1), on_x(9, 0)}) == "two cubes overlap");
  CHECK(error_of({on_x(2001, 0)}) == "a cube is not in the room");
  CHECK(error_of({on_x(0, -1), on_x(20, 1)}) == "");
  CHECK(error_of({on_x(0, 1)}) == "a cube touches a wall and leaves it");
  CHECK(error_of({on_x(5, 1), on_x(15, 2)}) == "two cubes touch and part");
  CHECK(error_of({on_x(5, 2), on_x(15, 2)}) == "");
}

TEST_CASE("gas: the shipped scene keeps everything, and its hashes are the same everywhere") {
  simulate::gas::GasScene scene = simulate::gas::read_gas(
      catalogue::parse_line(R"({"touchstone_scene":1,"gas":{"side":1048576,"cubes_along":6,"gap":1179648,)"
                            R"("speed":999,"seed":1,"until":9000}})"));
  CHECK(scene.cubes.size() == 216);
  std::ostringstream out;
  CHECK(run_gas(scene, out));
  CHECK(out.str().find("CHANGED") == std::string::npos);
}

TEST_CASE("gas: a scene's fields are told by place and rule") {
  const auto refusal = [](const std::string& gas) {
    return refusal_of(
        [&] { simulate::gas::read_gas(catalogue::parse_line("{\"touchstone_scene\":1,\"gas\":" + gas + "}")); });
  };
  const std::string rest = R"("cubes_along":2,"gap":3,"speed":1,"seed":1)";
  CHECK(refusal("{\"side\":5,\"until\":9," + rest + "}") == "accepted");
  CHECK(refusal("{\"side\":0,\"until\":9," + rest + "}") == "gas.side: expected an integer from 1 up, got 0");
  CHECK(refusal("{\"side\":1.5,\"until\":9," + rest + "}") == "gas.side: expected an integer below 2^32, got 1.5");
  CHECK(refusal("{\"side\":5," + rest + "}") == "gas.until: missing");
  CHECK(refusal("{\"side\":5,\"untill\":9," + rest + "}").substr(0, 32) == "gas.untill: no such field (did y");
}

}  // namespace touchstone::proptests::gas_tests
