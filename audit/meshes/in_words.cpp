// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/in_words.h"

#include <fmt/format.h>

#include "audit/counted.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t most_nested = 5;

std::string corners_in_words(std::size_t corners, std::size_t count) {
  const std::string noun = corners == 3   ? "triangle"
                           : corners == 4 ? "quadrilateral"
                                          : fmt::format("polygon of {} corners", corners);
  if (count == 1) return "1 " + noun;
  return fmt::format("{} {}", grouped(count),
                     corners < 5 ? noun + "s" : fmt::format("polygons of {} corners", corners));
}

std::string faces_in_words(const Diagnosis& diagnosis) {
  std::string text;
  for (const auto& [corners, count] : diagnosis.faces_by_corners)
    text += (text.empty() ? "" : ", ") + corners_in_words(corners, count);
  return diagnosis.faces_by_corners.size() < 2 ? text : counted(diagnosis.faces, "face") + " (" + text + ")";
}

std::string word(const char* name, const std::optional<bool>& holds) {
  return !holds ? std::string(name) + " not decided" : (*holds ? "" : "not ") + std::string(name);
}

const char* name_of(VolumeSign volume) {
  constexpr const char* names[]{"none", "negative", "zero", "positive"};
  return names[static_cast<std::size_t>(volume)];
}

Json lines_of(const std::vector<std::size_t>& places, const std::vector<std::size_t>& lines) {
  Json json = Json::array();
  for (const std::size_t i : places) json.push_back(lines[i]);
  return json;
}

Json places_of(const MeshFile& file, const FoundDefect& found) {
  Json places = Json::array();
  for (const PlaceInMesh& place : found.first) {
    Json json = Json::object();
    if (!place.faces.empty()) json["faces"] = place.faces;
    if (!place.faces.empty() && !file.face_lines.empty()) json["face_lines"] = lines_of(place.faces, file.face_lines);
    if (!place.vertices.empty()) json["vertices"] = place.vertices;
    if (!place.vertices.empty() && !file.vertex_lines.empty())
      json["vertex_lines"] = lines_of(place.vertices, file.vertex_lines);
    places.push_back(std::move(json));
  }
  return places;
}

}  // namespace

std::vector<std::string> description_of(const MeshFile& file, const Diagnosis& diagnosis) {
  std::vector<std::string> lines;
  lines.push_back(fmt::format("{}: {}, {}, {}, {}, {}", file.name, file.format, counted(diagnosis.vertices, "vertex"),
                              counted(diagnosis.edges, "edge"), faces_in_words(diagnosis),
                              counted(diagnosis.components, "part")));
  std::string spans;
  for (std::size_t axis = 0; axis < 3; ++axis)
    spans += fmt::format("{}{} {} to {}", axis == 0 ? "" : ", ", "xyz"[axis], decimal(diagnosis.low[axis]),
                         decimal(diagnosis.high[axis]));
  lines.push_back(spans);
  lines.push_back(
      word("closed", diagnosis.closed) + ", " + word("oriented", diagnosis.oriented) + ", " +
      word("a manifold at its edges", diagnosis.edge_manifold) + ", " +
      word("a manifold at its vertices", diagnosis.vertex_manifold) + ", " + word("embedded", diagnosis.embedded) +
      ", " + word("convex", diagnosis.convex) +
      (diagnosis.volume == VolumeSign::none ? std::string() : std::string(", volume ") + name_of(diagnosis.volume)));
  for (std::size_t k = 0; k < std::min(most_nested, diagnosis.nesting.size()); ++k)
    lines.push_back(fmt::format("part {} lies inside part {}", diagnosis.nesting[k].j + 1, diagnosis.nesting[k].i + 1));
  if (diagnosis.nesting.size() > most_nested)
    lines.push_back(fmt::format("{} more pairs of parts are nested", diagnosis.nesting.size() - most_nested));
  for (const std::string& done : diagnosis.done) lines.push_back("before this: " + done);
  for (const auto* notes : {&file.notes, &diagnosis.notes})
    for (const std::string& note : *notes) lines.push_back("note: " + note);
  return lines;
}

std::string verdict_of(const Diagnosis& diagnosis) {
  return diagnosis.solid() ? "It bounds a solid." : "It bounds no solid; the worst first:";
}

std::string defects_in_short(const Diagnosis& diagnosis) {
  if (diagnosis.solid()) return "it bounds a solid";
  std::string text;
  for (const FoundDefect& found : diagnosis.found) text += (text.empty() ? "" : "; ") + found.what;
  return text;
}

Json json_of(const MeshFile& file, const Diagnosis& diagnosis) {
  Json json = Json::object();
  json["file"] = file.name, json["format"] = file.format, json["solid"] = diagnosis.solid();
  json["vertices"] = diagnosis.vertices, json["edges"] = diagnosis.edges, json["faces"] = diagnosis.faces;
  json["faces_by_corners"] = Json::object();
  for (const auto& [corners, count] : diagnosis.faces_by_corners)
    json["faces_by_corners"][std::to_string(corners)] = count;
  json["components"] = diagnosis.components;
  for (const auto& [name, ends] : {std::pair{"min", &diagnosis.low}, std::pair{"max", &diagnosis.high}}) {
    json[name] = Json::array();
    for (const double x : *ends) json[name].push_back(written(x));
  }
  json["closed"] = diagnosis.closed, json["oriented"] = diagnosis.oriented;
  json["edge_manifold"] = diagnosis.edge_manifold, json["vertex_manifold"] = diagnosis.vertex_manifold;
  json["embedded"] = diagnosis.embedded ? Json(*diagnosis.embedded) : Json();
  json["convex"] = diagnosis.convex ? Json(*diagnosis.convex) : Json();
  json["volume"] = name_of(diagnosis.volume);
  json["nesting"] = Json::array();
  for (const IndexPair& pair : diagnosis.nesting) json["nesting"].push_back({pair.i, pair.j});
  json["found"] = Json::array();
  for (const FoundDefect& found : diagnosis.found) {
    json["found"].push_back(Json{{"defect", defect_names[static_cast<std::size_t>(found.defect)]},
                                 {"count", found.count},
                                 {"what", found.what},
                                 {"where", found.where},
                                 {"mend", found.mend},
                                 {"first", places_of(file, found)}});
  }
  json["reversed"] = diagnosis.reversed;
  json["done"] = diagnosis.done, json["notes"] = file.notes;
  for (const std::string& note : diagnosis.notes) json["notes"].push_back(note);
  return json;
}

}  // namespace touchstone::audit
