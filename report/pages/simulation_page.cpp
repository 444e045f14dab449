// SPDX-License-Identifier: Apache-2.0
#include "report/pages/simulation_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "catalogue/codec/nearest_double.h"
#include "report/parts/html_parts.h"
#include "report/words/wording.h"

namespace touchstone::report {
namespace {

using simulate::Json;
using simulate::Recording;
using simulate::State;

constexpr std::size_t most_frames = 2000;

/// Rounded to that many digits for display; if the result is out of range, all digits.
Json number(double x, int digits = 6) {
  const double shorter = catalogue::nearest_double(fmt::format("{:.{}g}", x, digits)).value_or(x);
  return std::isfinite(shorter) ? shorter : x;
}
template <class Triple>
Json three(const Triple& v) {
  return Json::array({number(v.x), number(v.y), number(v.z)});
}

Json bodies_of(const simulate::Scene& scene) {
  constexpr const char* shapes[]{"particle", "sphere", "box"};
  Json bodies = Json::array();
  for (const auto& body : scene.bodies) {
    bodies.push_back({{"name", body.name},
                      {"shape", shapes[static_cast<std::size_t>(body.shape)]},
                      {"radius", number(body.radius)},
                      {"half", three(body.half_extents)},
                      {"fixed", body.fixed}});
  }
  return bodies;
}

/// The walls of a room become one box, the others have normal and offset.
void add_walls(const simulate::Scene& scene, Json& data) {
  data["walls"] = Json::array();
  for (const auto& [name, plane] : scene.walls)
    if (name.rfind("room.", 0) != 0)
      data["walls"].push_back({{"name", name}, {"normal", three(plane.normal)}, {"offset", number(plane.offset)}});
  if (scene.text.contains("room")) data["room"] = {scene.text["room"]["min"], scene.text["room"]["max"]};
}

/// The greatest distance between the positions of a body in two states.
double apart(const State<double>& a, const State<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector3<double> d = a[i].position - b[i].position;
    most = std::max(most, std::sqrt(dot(d, d)));
  }
  return most;
}

Json run_of(const Recording::OfRun& run, const std::vector<std::size_t>& frames) {
  Json json{{"name", run.name}, {"frames", Json::array()}, {"contacts", Json::array()}};
  std::size_t before = 0;
  if (run.engine) json["engine"] = true;
  if (!run.ended.empty()) json["ended"] = run.ended;
  for (const std::size_t frame : frames) {
    if (frame >= run.states.size()) break;
    Json flat = Json::array();
    std::set<Json> contacts;  // one ring if a contact was resolved many times
    for (const auto& [p, v] : run.states[frame])
      for (const double x : {p.x, p.y, p.z, v.x, v.y, v.z}) flat.push_back(number(x));
    for (; before <= frame; ++before)
      for (const auto& impact : run.impacts[before]) contacts.insert(three(impact.point));
    json["frames"].push_back(std::move(flat));
    json["contacts"].push_back(Json(contacts));
    json["energy"].push_back(number(run.energy[frame], 9));
    json["law"].push_back(number(run.law[frame], 4));
    json["scheme"].push_back(number(run.scheme[frame], 4));
    json["decision"].push_back(number(run.decision[frame], 4));
    json["rounding"].push_back(number(run.rounding[frame], 4));
    const auto& [x, y, z] = run.momentum[frame];
    json["momentum"].push_back({number(x), number(y), number(z)});
  }
  return json;
}

Json distances(const std::vector<Recording::OfRun>& runs, const std::vector<std::size_t>& frames) {
  Json distances = Json::array();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t j = i + 1; j < runs.size(); ++j) {
      // There may be many engines: each is compared only with robust.
      if ((runs[i].engine || runs[j].engine) && runs[i].name != "robust") continue;
      if (runs[j].states.empty()) continue;
      Json values = Json::array();
      for (const std::size_t frame : frames)
        if (frame < runs[j].states.size())
          values.push_back(number(apart(runs[i].states[frame], runs[j].states[frame]), 4));
      distances.push_back({{"runs", {runs[i].name, runs[j].name}}, {"values", values}});
    }
  }
  return distances;
}

std::string parting_in_html(const std::pair<std::uint64_t, Json>& found) {
  const auto& [step, parting] = found;
  const std::string first = parting["runs"][0], second = parting["runs"][1], operation = parting["operation"];
  std::string text = fmt::format("<h3>{} and {} part in step {}: {}</h3>", escaped(first), escaped(second), step,
                                 escaped(parting["contact"].get<std::string>()));
  for (const std::string& run : {first, second})
    text += "<p>" + escaped(run) + " answers " + code(catalogue::one_line(parting[run]["answer"])) + " to</p>" +
            shell_line("echo '" + catalogue::one_line(parting[run]["question"]) + "' | touchstone ask " + operation);
  return text;
}

}  // namespace

Json player_data(const Recording& recording) {
  const simulate::Scene& scene = recording.scene();
  const std::size_t stride = (recording.frames() + most_frames - 1) / most_frames;
  std::vector<std::size_t> frames;
  for (std::size_t frame = 0; frame < recording.frames(); frame += stride) frames.push_back(frame);
  Json data{{"timestep", number(scene.settings.timestep)}, {"stride", stride}, {"bodies", bodies_of(scene)}};
  add_walls(scene, data);
  data["runs"] = Json::array();
  for (const auto& run : recording.runs())
    if (!run.states.empty()) data["runs"].push_back(run_of(run, frames));
  data["distances"] = distances(recording.runs(), frames);
  data["partings"] = Json::array();
  for (const auto& [step, parting] : recording.partings())
    data["partings"].push_back({{"step", step}, {"runs", parting["runs"]}, {"contact", parting["contact"]}});
  return data;
}

std::string simulation_page(const Recording& recording) {
  const simulate::Scene& scene = recording.scene();
  const std::string title = scene.title.empty() ? "A scene in several arithmetics" : scene.title;
  std::string body =
      "<header><p class=\"kicker\">touchstone simulate</p><h1>" + escaped(title) + "</h1><p class=\"lead\">" +
      escaped(scene.about) + "</p></header><main>" + player_opening +
      escaped(catalogue::one_line(player_data(recording))) +
      "\"><noscript><p>The page plays its runs by a script, which it carries in itself.</p></noscript></div>";
  if (!recording.partings().empty()) body += "<h2>What decided</h2>";
  for (const auto& parting : recording.partings()) body += parting_in_html(parting);
  return page(title, body + "</main>");
}

}  // namespace touchstone::report
