// SPDX-License-Identifier: Apache-2.0
#include <istream>

#include "catalogue/codec/expected.h"
#include "simulate/trajectory.h"
#include "simulate/world/hash.h"

namespace touchstone::simulate {
namespace {

using catalogue::expected;

/// A value that was read back, and its position for complaints.
struct Place {
  const Json& json;
  std::string path;

  Place at(const std::string& name) const {
    if (!json.is_object() || !json.contains(name)) throw InvalidInput(path + "." + name, "missing");
    return {json[name], path + "." + name};
  }
  Place at(std::size_t i) const {
    if (!json.is_array() || i >= json.size()) throw InvalidInput(path, "too short a list");
    return {json[i], path + "[" + std::to_string(i) + "]"};
  }
  double number() const {
    if (!json.is_number()) throw InvalidInput(path, expected("a number", json));
    return json.get<double>();
  }
  std::size_t index(std::size_t size) const {
    if (!json.is_number_unsigned() || json.get<std::size_t>() >= size)
      throw InvalidInput(path, expected("an integer below " + std::to_string(size), json));
    return json.get<std::size_t>();
  }
  mpq_class rational() const {
    mpq_class value;
    if (!json.is_string() || value.set_str(json.get<std::string>(), 10) != 0 || sgn(value.get_den()) == 0)
      throw InvalidInput(path, expected("a fraction", json));
    value.canonicalize();
    return value;
  }
  void require(const std::string& text) const {
    if (json != text) throw InvalidInput(path, expected(text + ", which its numbers have", json));
  }
  template <class Triple>
  Triple three(std::size_t first = 0) const {
    return {at(first).number(), at(first + 1).number(), at(first + 2).number()};
  }
};

Impact impact_of(const Place& place, const Scene& scene) {
  const bool wall = place.json.contains("wall");
  const std::size_t others = wall ? scene.walls.size() : scene.bodies.size();
  const Touch touch{wall, place.at("body").index(scene.bodies.size()), place.at(wall ? "wall" : "other").index(others)};
  return {touch, place.at("time").number(), place.at("point").three<Point3d>(), place.at("normal").three<Vector3d>()};
}

/// Checks the hashes, and that the drift is the change of energy, which is 0 at the start.
Snapshot snapshot_of(const Place& place, const Scene& scene, const Snapshot* before) {
  Snapshot then;
  const Place bodies = place.at("bodies"), contacts = place.at("contacts"), drift = place.at("drift");
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    then.state.push_back({bodies.at(i).three<Point3d>(), bodies.at(i).three<Vector3d>(3)});
  for (std::size_t i = 0; i < contacts.json.size(); ++i) then.impacts.push_back(impact_of(contacts.at(i), scene));
  const State<Exact> exact = in_exact(then.state);
  then.energy = energy(scene, exact);
  then.momentum = momentum(scene, exact);
  then.drift = {drift.at("law").rational(), drift.at("scheme").rational(), drift.at("decision").rational(),
                drift.at("rounding").rational()};
  then.hash = hash_of(scene, then.state);
  then.chain = chained(before == nullptr ? 0 : before->chain, then.hash);
  place.at("energy").require(catalogue::written(then.energy).get<std::string>());
  place.at("hash").require(in_digits(then.hash));
  place.at("chain").require(in_digits(then.chain));
  if (before == nullptr) {
    for (const char* part : {"law", "scheme", "decision", "rounding"})
      if (sgn(drift.at(part).rational()) != 0) throw InvalidInput(drift.at(part).path, "0 before the first step");
  } else if (then.energy - before->energy != then.drift.total()) {
    throw InvalidInput(drift.path, "its parts add up to the change of energy");
  }
  return then;
}

/// Notes which runs have answered different contacts.
void note_partings(const Frame& frame, std::vector<std::pair<std::size_t, std::size_t>>& parted) {
  for (std::size_t i = 0; i < frame.runs.size(); ++i)
    for (std::size_t j = i + 1; j < frame.runs.size(); ++j)
      if (!same_contacts(frame.runs[i], frame.runs[j])) parted.emplace_back(i, j);
}

std::vector<Json> partings_in(const Place& line) {
  if (!line.json.contains("parted")) return {};
  const Json& list = line.at("parted").json;
  for (const Json& parting : list)
    for (const char* field : {"runs", "contact", "operation"})
      if (!parting.is_object() || !parting.contains(field))
        throw InvalidInput(line.path + ".parted", "what a run wrote");
  return {list.begin(), list.end()};
}

}  // namespace

std::uint64_t read_trajectory(std::istream& in, Simulation& simulation,
                              const std::function<void(const Frame&)>& visit) {
  Frame frame{0, std::vector<Snapshot>(simulation.size()), std::vector<Drift>(simulation.size()), {}};
  std::vector<std::pair<std::size_t, std::size_t>> parted;
  std::uint64_t length = 0, lines = 0;
  for (std::string text; std::getline(in, text) && !in.eof(); ++lines) {
    const std::string name = "line " + std::to_string(lines + 1);
    const Json json = catalogue::parse_own_line(text);
    if (lines == 0) {
      if (json != catalogue::parse_own_line(catalogue::one_line(header_of(simulation))))
        throw InvalidInput(name, "the trajectory is of another scene, or of other runs");
    } else {
      const Place line{json, name};
      frame.step = lines - 1;
      if (line.at("step").json != frame.step)
        throw InvalidInput(name + ".step", expected(std::to_string(frame.step), line.at("step").json));
      for (std::size_t i = 0; i < simulation.size(); ++i) {
        const Snapshot before = frame.runs[i];
        frame.runs[i] =
            snapshot_of(line.at(simulation.run(i).name()), simulation.scene(), lines == 1 ? nullptr : &before);
        frame.drifts[i] += frame.runs[i].drift;
      }
      note_partings(frame, parted);
      frame.partings = partings_in(line);
      visit(frame);
    }
    length += text.size() + 1;
  }
  if (lines > 1) simulation.restore(frame.step, frame.runs, frame.drifts, parted);
  return length;
}

}  // namespace touchstone::simulate
