// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/in_file.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "audit/counted.h"
#include "audit/meshes/formats/reading.h"
#include "audit/meshes/merged.h"

namespace touchstone::audit {
namespace {

/// Reads the words of a rule from the left.
struct RuleText {
  std::string_view rest;

  bool skip(std::string_view text) {
    if (!rest.starts_with(text)) return false;
    rest.remove_prefix(text.size());
    return true;
  }
  std::optional<Index> number() {
    Index number = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc{}) return std::nullopt;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return number;
  }
  /// "3 -> 4", and "3 to vertex 4" of an edge.
  std::optional<std::pair<Index, Index>> edge(bool named) {
    RuleText text = *this;
    const auto from = text.number();
    if (!from || !(text.skip(" -> ") || (named && text.skip(" to vertex ")))) return std::nullopt;
    const auto to = text.number();
    if (!to) return std::nullopt;
    *this = text;
    return std::pair{*from, *to};
  }
};

/// A rule with the vertices and edges of the file.
std::string rule_in_file(const MeshFile& file, const PreparedMesh& mesh, const std::string& rule) {
  const auto in_file = [&](Index vertex) { return mesh.vertex_in_file.at(vertex); };
  std::string result;
  for (RuleText text{rule}; !text.rest.empty();) {
    RuleText ahead = text;
    const bool edge_named = ahead.skip("edge ");
    if (edge_named) ahead.skip("from vertex ");
    if (const auto edge = ahead.edge(edge_named)) {
      const auto from = in_file(edge->first), to = in_file(edge->second);
      if (edge_named) result += edge_in_words(file, from, to);
      else result += "from " + vertex_named(file, from) + " to " + vertex_named(file, to);
      text = ahead;
      continue;
    }
    ahead = text;
    const auto vertex = ahead.skip("vertex ") ? ahead.number() : std::nullopt;
    if (vertex) {
      result += vertex_in_words(file, in_file(*vertex));
      text = ahead;
    } else {
      result += text.rest.front();
      text.rest.remove_prefix(1);
    }
  }
  return result;
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
  const std::size_t face = mesh.face_in_file.at(RuleText{std::string_view(rest).substr(faces.size())}.number().value());
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
