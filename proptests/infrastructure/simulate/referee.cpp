// SPDX-License-Identifier: Apache-2.0
#include "simulate/gas/referee.h"

#include <cmath>
#include <fstream>
#include <iterator>

#include "proptests/infrastructure/simulate/scene_text.h"

/// An exact gas as referee: engines of our own, which part from it at a hit that is known.
namespace touchstone::proptests::referee_tests {
namespace {

using catalogue::Json;
using simulate::gas::GasScene;
using simulate::gas::Int64;
using simulate::gas::Verdict;

/// How an engine differs from one that answers everything.
struct Habits {
  bool pairs = true, walls = true;
  int late = 0;             ///< steps between a contact and its answer
  double noise = 0;         ///< added to every velocity that is told, m/s
  std::size_t slows = 0;    ///< the number of the answer that takes half the speed; 0: none
  std::uint64_t stops = 0;  ///< the step at whose end `stopped` rests without a contact; 0: none
  std::size_t stopped = 0;
  std::uint64_t crashes = 0;  ///< the step that it does not answer; 0: none
};

/// Moves boxes by whole steps. Boxes that overlap and approach exchange their velocities along the axis on which they
/// overlap least; a wall turns one round.
class OwnEngine : public simulate::EngineLines {
 public:
  explicit OwnEngine(const Habits& habits) : habits_(habits) {}

  std::string answer_to(const std::string& line) override {
    const Json json = Json::parse(line);
    if (json.contains("scene")) {
      scene_ = json["scene"];
      for (const Json& body : scene_["bodies"]) bodies_.push_back({body["position"], body["velocity"], {}});
      return R"({"engine":"own"})";
    }
    ++step_;
    if (step_ == habits_.crashes) throw simulate::EngineFailure("signal 11");
    for (Body& body : bodies_)
      for (int k = 0; k < 3; ++k) body.position[k] += scene_["timestep"].get<double>() * body.velocity[k];
    answer_walls(), answer_pairs();
    if (step_ == habits_.stops) bodies_[habits_.stopped].velocity = {0, 0, 0};
    Json reply{{"step", step_}, {"bodies", Json::array()}};
    for (const auto& [p, v, since] : bodies_)
      reply["bodies"].push_back({p[0], p[1], p[2], v[0] + habits_.noise, v[1] + habits_.noise, v[2] + habits_.noise});
    return reply.dump();
  }

 private:
  struct Body {
    std::array<double, 3> position, velocity;
    std::array<int, 3> since;  ///< how many steps ago a contact on the axis began; 0: there is none
  };

  /// A contact counts once it is old enough, and each answer is counted.
  bool due(Body& body, int axis) { return body.since[axis]++ >= habits_.late; }
  double factor() { return ++answers_ == habits_.slows ? 0.5 : 1; }

  void answer_walls() {
    if (!habits_.walls) return;
    for (const Json& wall : scene_["walls"]) {
      for (Body& body : bodies_) {
        for (int k = 0; k < 3; ++k) {
          const double n = wall["normal"][k];
          if (n == 0 || n * body.velocity[k] >= 0) continue;
          if (n * body.position[k] + wall["offset"].get<double>() > 0.5 || !due(body, k)) continue;
          body.velocity[k] *= -factor(), body.since[k] = 0;
        }
      }
    }
  }
  void answer_pairs() {
    for (std::size_t i = 0; habits_.pairs && i < bodies_.size(); ++i)
      for (std::size_t j = i + 1; j < bodies_.size(); ++j) answer_pair(bodies_[i], bodies_[j]);
  }
  void answer_pair(Body& a, Body& b) {
    int axis = 0;
    double least = 2;
    for (int k = 0; k < 3; ++k) {
      const double depth = 1 - std::abs(a.position[k] - b.position[k]);
      if (depth < 0) return;
      if (depth < least) least = depth, axis = k;
    }
    if ((b.position[axis] - a.position[axis]) * (b.velocity[axis] - a.velocity[axis]) >= 0 || !due(a, axis)) return;
    std::swap(a.velocity[axis], b.velocity[axis]);
    const double by = factor();
    a.velocity[axis] *= by, b.velocity[axis] *= by, a.since[axis] = 0;
  }

  Habits habits_;
  Json scene_;
  std::vector<Body> bodies_;
  std::uint64_t step_ = 0;
  std::size_t answers_ = 0;
};

/// Cubes of 4 in a room of 44, 4 being 1 m/s. Cube 0 flies along x and meets cube 1 at 3 s; that one meets the wall at
/// 7 s and cube 0 at 11 s; cube 0 meets the other wall at 16 s, and cube 1 again at 21 s. Cube 2 lies alone.
GasScene five_hits(Int64 until = 22) {
  GasScene gas;
  gas.side = 4, gas.room = 40, gas.speed = 4, gas.until = until;
  gas.steps_per_second = 8;
  gas.cubes = {{{8, 10, 10}, {4, 0, 0}}, {{24, 10, 10}, {0, 0, 0}}, {{20, 30, 10}, {0, 0, 0}}};
  return gas;
}

Verdict verdict_of(const Habits& habits, const GasScene& gas = five_hits()) {
  return simulate::gas::referee(gas, std::make_unique<OwnEngine>(habits), "own");
}

/// The number of the hit at which it parts; 0: at none.
std::size_t parts_at(const Habits& habits, const GasScene& gas = five_hits()) {
  const Verdict verdict = verdict_of(habits, gas);
  CHECK(verdict.ended.empty());
  return verdict.wrong ? verdict.wrong->hit + 1 : 0;
}

}  // namespace

TEST_CASE("referee: the hits of a gas are told in order, with the velocities after them") {
  const simulate::gas::Record record(five_hits(), 22);
  REQUIRE(record.hits().size() == 5);
  const Int64 times[]{3, 7, 11, 16, 21};
  for (std::size_t i = 0; i < 5; ++i) CHECK(record.hits()[i].at.p == times[i] * record.hits()[i].at.q);
  CHECK(record.hits()[0].cubes == std::vector<std::size_t>{0, 1});
  CHECK(record.hits()[0].velocities == std::vector<std::array<Int64, 3>>{{0, 0, 0}, {4, 0, 0}});
  CHECK(record.hits()[1].cubes == std::vector<std::size_t>{1});
  CHECK(record.hits()[1].velocities == std::vector<std::array<Int64, 3>>{{-4, 0, 0}});
  REQUIRE(record.turns(0).size() == 5);
  CHECK(record.turns(0)[2].hit == 2);
  CHECK(record.turns(2).size() == 1);
}

TEST_CASE("referee: an engine that answers everything does not part, however late it is, or however it rounds") {
  const Verdict verdict = verdict_of({});
  CHECK_FALSE(verdict.wrong);
  CHECK(verdict.hits == 5);
  CHECK(verdict.latest <= 1);
  CHECK(parts_at({.late = 4}) == 0);
  CHECK(verdict_of({.late = 4}).latest > 4);
  CHECK(parts_at({.noise = 0.1}) == 0);   // 0.4 of a unit
  CHECK(parts_at({.noise = 0.15}) == 1);  // 0.6 of a unit
}

TEST_CASE("referee: an engine parts at the first hit that it misses, or comes out of with another velocity") {
  CHECK(parts_at({.pairs = false}) == 1);
  CHECK(parts_at({.walls = false}) == 2);
  for (std::size_t number = 1; number <= 5; ++number) {
    CAPTURE(number);
    CHECK(parts_at({.slows = number}) == number);
  }
  const Verdict slow = verdict_of({.slows = 4});
  CHECK(slow.wrong->cube == 0);
  CHECK(slow.wrong->velocity == std::array<double, 3>{2, 0, 0});
  CHECK(sentence_of(five_hits(), slow) ==
        "own: parts at hit 4 of 5, cube_0 and a wall at 16.0000 s: in step 128 cube_0 has (2, 0, 0) in place of (4, 0, "
        "0)");
  CHECK(sentence_of(five_hits(), verdict_of({.walls = false})) ==
        "own: parts at hit 2 of 5, cube_1 and a wall at 7.0000 s: which it does not answer");
}

TEST_CASE("referee: what no hit explains counts before the hit that comes next") {
  CHECK(parts_at({.stops = 8 * 9, .stopped = 1}) == 3);
  CHECK(parts_at({.stops = 8, .stopped = 0}) == 1);
  // What stands still may stop.
  CHECK(parts_at({.stops = 8 * 9, .stopped = 2}) == 0);
}

TEST_CASE("referee: hits after the end of the gas are not judged, and whoever is late has time") {
  CHECK(verdict_of({}, five_hits(15)).hits == 3);
  CHECK(parts_at({.slows = 4}, five_hits(15)) == 0);
  CHECK(parts_at({.late = 4}, five_hits(3)) == 0);
}

TEST_CASE("referee: two hits of a cube within a step are one reading") {
  GasScene corner = five_hits();
  corner.steps_per_second = 1;
  // The walls are met at 8 - 1/4 and 8 - 1/2 s.
  corner.cubes = {{{9, 10, 10}, {4, 4, 0}}};
  CHECK(simulate::gas::Record(corner, 22).hits()[0].at.p == 15 * 2);
  CHECK(verdict_of({}, corner).hits == 4);
  CHECK(parts_at({}, corner) == 0);
  CHECK(parts_at({.slows = 2}, corner) == 1);
}

TEST_CASE("referee: an engine that ends has no verdict but its end, unless it parted before") {
  const Verdict early = verdict_of({.crashes = 5});
  CHECK(early.ended == "step 5: signal 11");
  CHECK_FALSE(early.wrong);
  CHECK(sentence_of(five_hits(), early) == "own: step 5: signal 11");
}

TEST_CASE("referee: a gas whose unit became smaller is no referee") {
  GasScene gas = five_hits();
  gas.cubes = {{{1, 20, 20}, {4, 0, 0}}, {{13, 17, 20}, {0, 0, 0}}, {{13, 23, 20}, {0, 0, 0}}};
  CHECK_THROWS_AS(verdict_of({}, gas), simulate::gas::GasError);
}

TEST_CASE("referee: a gas in the plane is known as one") {
  std::ifstream in("simulate/scenes/gas_in_the_plane.json");
  const GasScene plane =
      simulate::gas::read_gas(catalogue::parse_line(std::string(std::istreambuf_iterator<char>(in), {})));
  CHECK(plane.cubes.size() == 25);
  CHECK(is_planar(scene_of(plane)));
}

}  // namespace touchstone::proptests::referee_tests
