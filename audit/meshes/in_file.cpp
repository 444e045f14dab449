// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/in_file.h"

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <regex>

#include "audit/counted.h"
#include "audit/meshes/formats/reading.h"
#include "audit/meshes/merged.h"

namespace touchstone::audit {
namespace {

std::size_t whole(const std::string& digits) { return std::strtoull(digits.c_str(), nullptr, 10); }

/// A rule with the vertices and edges of the file.
std::string rule_in_file(const MeshFile& file, const PreparedMesh& mesh, const std::string& rule) {
  static const std::regex named("edge (?:from vertex )?(\\d+) (?:->|to vertex) (\\d+)|(\\d+) -> (\\d+)|vertex (\\d+)");
  std::string result;
  std::sregex_iterator match(rule.begin(), rule.end(), named);
  std::size_t behind = 0;
  for (; match != std::sregex_iterator(); ++match) {
    result += match->prefix();
    behind = static_cast<std::size_t>(match->position() + match->length());
    const auto vertex = [&](std::size_t group) { return mesh.vertex_in_file.at(whole((*match)[group])); };
    if ((*match)[1].matched) {
      result += edge_in_words(file, vertex(1), vertex(2));
    } else if ((*match)[3].matched) {
      result += "from " + vertex_named(file, vertex(3)) + " to " + vertex_named(file, vertex(4));
    } else {
      result += vertex_in_words(file, vertex(5));
    }
  }
  return result + rule.substr(behind);
}

std::string what_is_left(const std::string& option, std::size_t open) {
  if (open == 0) return "; with " + option + " it is closed";
  return "; with " + option + " " + counted(open, "edge") + (open == 1 ? " stays open" : " stay open");
}

/// "14 pairs of vertices have equal positions", or the counts of larger groups.
std::string equal_positions(const Merging& merging) {
  std::map<Index, std::size_t> groups;
  for (Index v = 0; v < merging.into.size(); ++v)
    if (merging.into[v] != v) ++groups[merging.into[v]];
  if (merging.merged > groups.size())
    return meshes::vertices(merging.merged + groups.size()) + " have " + counted(groups.size(), "position");
  return counted(merging.merged, "pair") + " of vertices " + (merging.merged == 1 ? "has" : "have") +
         " equal positions";
}

}  // namespace

std::optional<InvalidInput> in_file(const MeshFile& file, const PreparedMesh& mesh, const std::string& field,
                                    const InvalidInput& refused) {
  if (!refused.field().starts_with(field)) return std::nullopt;
  const std::string rest = refused.field().substr(field.size());
  const std::string rule = rule_in_file(file, mesh, refused.rule());
  if (rest.empty()) return InvalidInput(file.name, field + ": " + rule);
  const std::string faces = ".faces[";
  if (!rest.starts_with(faces)) return std::nullopt;
  const std::size_t face = mesh.face_in_file.at(whole(rest.substr(faces.size())));
  return InvalidInput(place_of_face(file, face),
                      "face " + std::to_string(face + file.first_number) + " (" + refused.field() + "): " + rule);
}

Json places_in_file(const MeshFile& file, const PreparedMesh& mesh, const Json& truth) {
  Json places = Json::object();
  if (!truth.is_object()) return places;
  const auto vertex = [&](const Json& index) { return mesh.vertex_in_file.at(index.get<std::size_t>()); };
  const auto face = [&](const Json& index) { return mesh.face_in_file.at(index.get<std::size_t>()); };
  for (const auto& [name, value] : truth.items()) {
    if (name.ends_with("_edge")) {
      places[name] = edge_in_words(file, vertex(value.at(0)), vertex(value.at(1)));
    } else if (name.ends_with("_vertex")) {
      places[name] = vertex_in_words(file, vertex(value));
    } else if (name.ends_with("_faces")) {
      places[name] = faces_in_words(file, face(value.at(0)), face(value.at(1)));
    } else if (name.ends_with("_face") && value.is_object()) {
      places[name] = face_in_words(file, face(value.at("face"))) + ", whose plane has " +
                     vertex_in_words(file, vertex(value.at("one"))) + " on one side and " +
                     vertex_in_words(file, vertex(value.at("other"))) + " on the other";
    } else if (name.ends_with("_face")) {
      places[name] = face_in_words(file, face(value));
    }
  }
  return places;
}

std::vector<std::string> hints_of_merging(const MeshFile& file, const Preparation& how) {
  std::vector<std::string> hints;
  if (how.merge && *how.merge > 0) return hints;
  const Merging equal = merging_of(file.vertices, 0);
  const std::size_t open = count_open_edges(faces_after(file.faces, equal));
  if (!how.merge && equal.merged > 0 && open < count_open_edges(file.faces))
    hints.push_back(equal_positions(equal) + what_is_left("--merge", open));
  if (open == 0) return hints;
  const auto closes = merging_that_closes(file.vertices, file.faces, open);
  if (!closes) return hints;
  hints.push_back(vertices_in_words(file, closes->one, closes->other) + " are " +
                  apart_in_words(closes->apart, size_of(file.vertices)) +
                  what_is_left(fmt::format("--merge {:g}", closes->tolerance), closes->open));
  return hints;
}

}  // namespace touchstone::audit
