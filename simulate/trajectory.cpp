// SPDX-License-Identifier: Apache-2.0
#include "simulate/trajectory.h"

#include "simulate/fields.h"
#include "simulate/world/hash.h"

namespace touchstone::simulate {
namespace {

using catalogue::written;

Json bodies_of(const State<double>& state) {
  Json bodies = Json::array();
  for (const auto& [p, v] : state) {
    Json body = three(p);
    for (const double x : {v.x, v.y, v.z}) body.push_back(written(x));
    bodies.push_back(std::move(body));
  }
  return bodies;
}

Json contact_of(const Impact& impact) {
  Json contact = Json::object();
  contact["body"] = impact.touch.body;
  contact[impact.touch.wall ? "wall" : "other"] = impact.touch.other;
  contact["time"] = written(impact.time);
  contact["point"] = three(impact.point);
  contact["normal"] = three(impact.normal);
  if (impact.rise > 0) contact["rise"] = written(impact.rise);
  return contact;
}

Json in_json(const Snapshot& now, bool of_engine) {
  Json json = Json::object();
  json["bodies"] = bodies_of(now.state);
  json["contacts"] = Json::array();
  for (const Impact& impact : now.impacts) json["contacts"].push_back(contact_of(impact));
  json["energy"] = written(now.energy);
  json["momentum"] = Json::array();
  for (const mpq_class& sum : now.momentum) json["momentum"].push_back(written(sum));
  json["drift"]["law"] = written(now.drift.law);
  json["drift"]["scheme"] = written(now.drift.scheme);
  if (of_engine) {
    json["drift"]["own"] = written(now.drift.own);
  } else {
    json["drift"]["decision"] = written(now.drift.decision);
    json["drift"]["rounding"] = written(now.drift.rounding);
  }
  json["hash"] = in_digits(now.hash);
  json["chain"] = in_digits(now.chain);
  return json;
}

/// Quotes a field with any characters as in RFC 4180: a quote within it is doubled.
std::string csv_quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string(2, c) : std::string(1, c);
  return quoted + '"';
}
/// Unquoted if that makes no difference.
std::string csv_field(const std::string& text) {
  return text.find_first_of(",\"\r\n") == std::string::npos ? text : csv_quoted(text);
}

Json in_json(const Asked& asked) { return {{"question", asked.question}, {"answer", asked.answer}}; }

}  // namespace

Json in_json(const Scene& scene, const Parting& parting) {
  return {{"runs", {parting.first, parting.second}},
          {"contact", name_of(scene, parting.touch)},
          {"operation", parting.by_first.operation},
          {parting.first, in_json(parting.by_first)},
          {parting.second, in_json(parting.by_second)}};
}

Json header_of(const Simulation& simulation) {
  Json runs = Json::array();
  for (std::size_t i = 0; i < simulation.size(); ++i) runs.push_back(simulation.run(i).name());
  Json header{{"touchstone_trajectory", 1}, {"runs", runs}};
  for (std::size_t i = 0; i < simulation.size(); ++i)
    if (const EngineRun* const engine = simulation.run(i).engine())
      header["engines"][engine->name()] = {{"number", engine->hello().binary32 ? "binary32" : "binary64"},
                                           {"thresholds", engine->hello().thresholds}};
  header["scene"] = simulation.scene().text;
  return header;
}

void write_header(const Simulation& simulation, std::ostream& out) {
  out << catalogue::one_line(header_of(simulation)) << '\n';
}

void write_step(const Simulation& simulation, std::ostream& out) {
  Json line = Json::object();
  line["step"] = simulation.step();
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    const Run& run = simulation.run(i);
    if (run.ended().empty()) line[run.name()] = in_json(run.now(), run.engine() != nullptr);
    else line["ended"][run.name()] = run.ended();
  }
  for (const Parting& parting : simulation.partings())
    if (parting.step == simulation.step()) line["parted"].push_back(in_json(simulation.scene(), parting));
  out << catalogue::one_line(line) << '\n';
}

void write_csv_header(std::ostream& out) { out << "step,run,body,x,y,z,vx,vy,vz\n"; }

void write_csv_step(const Simulation& simulation, std::ostream& out) {
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    if (!simulation.run(i).ended().empty()) continue;
    const State<double>& state = simulation.run(i).now().state;
    for (std::size_t body = 0; body < state.size(); ++body) {
      const auto& [p, v] = state[body];
      out << simulation.step() << ',' << csv_field(simulation.run(i).name()) << ','
          << csv_quoted(simulation.scene().bodies[body].name);
      for (const double x : {p.x, p.y, p.z, v.x, v.y, v.z}) out << ',' << catalogue::decimal(x);
      out << '\n';
    }
  }
}

}  // namespace touchstone::simulate
