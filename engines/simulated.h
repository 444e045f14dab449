// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// A scene for an engine of rigid bodies, and the loop that makes its steps over pipes (docs/simulate.md).
namespace simulated {

using Json = nlohmann::ordered_json;
using Three = std::array<double, 3>;

/// Bodies and walls by index. Fields are named as in the greeting.
struct Body {
  bool sphere, fixed;
  double radius, mass;
  Three half_extents, position, velocity;
};
struct Wall {
  Three normal;   ///< of length 1
  double offset;  ///< of the plane with that normal
};
struct Scene {
  bool continuous;  ///< option 2: where the engine has continuous detection it is on
  double timestep, restitution;
  Three gravity;
  std::vector<Wall> walls;
  std::vector<Body> bodies;
};

inline Scene scene_of(const Json& json) {
  Scene scene{json["option"] == 2, json["timestep"], json.value("restitution", 0.0), json["gravity"], {}, {}};
  for (const Json& wall : json["walls"]) {
    Three normal = wall["normal"];
    const double length = std::hypot(normal[0], normal[1], normal[2]), offset = wall["offset"];
    for (double& x : normal) x /= length;
    scene.walls.push_back({normal, offset / length});
  }
  for (const Json& body : json["bodies"])
    scene.bodies.push_back({body["shape"] == "sphere", body["fixed"], body.value("radius", 0.0), body["mass"],
                            body.value("half_extents", Three{}), body["position"], body["velocity"]});
  return scene;
}

/// What an engine reports of its contacts: those in which it used an impulse. A wall has the number of bodies added.
class Contacts {
 public:
  explicit Contacts(std::size_t bodies) : bodies_(bodies) {}
  void add(std::size_t a, std::size_t b) { pairs_.emplace(std::min(a, b), std::max(a, b)); }
  void forget() { pairs_.clear(); }
  Json taken() {
    Json list = Json::array();
    for (const auto& [a, b] : pairs_)
      if (a < bodies_) list.push_back({{"body", a}, {b < bodies_ ? "other" : "wall", b < bodies_ ? b : b - bodies_}});
    pairs_.clear();
    return list;
  }

 private:
  std::size_t bodies_;
  std::set<std::pair<std::size_t, std::size_t>> pairs_;
};

/// Runs Engine(const Scene&), its step(Contacts&), and body(i), a position and a velocity in one list.
template <class Engine>
int run(const Json& hello) {
  std::string line;
  if (!std::getline(std::cin, line)) return 1;
  std::cout << hello.dump() << std::endl;
  const Scene scene = scene_of(Json::parse(line)["scene"]);
  Engine engine(scene);
  Contacts contacts(scene.bodies.size());
  while (std::getline(std::cin, line)) {
    engine.step(contacts);
    Json answer{{"step", Json::parse(line)["step"]}, {"bodies", Json::array()}};
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) answer["bodies"].push_back(engine.body(i));
    answer["contacts"] = contacts.taken();
    std::cout << answer.dump() << std::endl;
  }
  return 0;
}

}  // namespace simulated
