// SPDX-License-Identifier: Apache-2.0
#include "program/file_meshes.h"

#include <cmath>
#include <map>
#include <ostream>
#include <utility>

#include "audit/meshes/in_file.h"
#include "audit/meshes/merged.h"
#include "program/names.h"

namespace touchstone::program {
namespace {

/// Of --merge, which may stand alone before the next option.
double tolerance_of(const std::string& text) {
  double value = 0;
  if (text.empty() || text == "true") return 0;
  if (CLI::detail::lexical_cast(text, value) && value >= 0 && value <= most_to_merge) return value;
  throw UsageError("--merge: expected a number from 0 to 0.01, got " + text +
                   " (files come before --merge, or write --merge=0)");
}

const CLI::Validator not_negative(
    [](std::string& text) {
      double value = 0;
      const bool right = CLI::detail::lexical_cast(text, value) && value >= 0;
      return right ? std::string() : "expected a number that is not negative, got " + text;
    },
    "NUMBER");

}  // namespace

std::vector<CLI::Option*> add_preparation(CLI::App& command, Preparation& how) {
  auto* const merge = command.add_option_function<std::string>(
      "--merge", [&how](const std::string& text) { how.merge = tolerance_of(text); },
      "Vertices of a mesh file in equal positions become one; with a number, at most 0.01, those nearer than that part "
      "of the longest side of the mesh's box, and all that such pairs join");
  merge->expected(0, 1)->default_str("0");
  auto* const planar =
      command.add_option("--planar", how.planar,
                         "Faces of a mesh file that are not planar, but whose corners lie at most so far apart across "
                         "them, in the file's unit, are cut as they are seen along the axis nearest to their normal");
  planar->check(not_negative)->default_str("");
  auto* const cut = command.add_option_function<std::string>(
      "--cut",
      [&how](const std::string& word) { how.cut = word == "fan" ? Preparation::Cut::fan : Preparation::Cut::shortest; },
      "Faces of a mesh file that are not planar are cut: as a fan from the first corner, or along shortest diagonals");
  cut->check(CLI::IsMember({"fan", "shortest"}))->default_str("");
  return {merge, planar, cut};
}

FileMeshes::FileMeshes(const std::vector<std::string>& named, const Preparation& how) : how_(how) {
  for (const std::string& word : named) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0) throw UsageError("--mesh: expected field=FILE, got " + word);
    const std::string field = word.substr(0, equals);
    if (fields_.contains(field)) throw UsageError("--mesh: " + field + " is given twice");
    MeshFile file = read_mesh_file(word.substr(equals + 1));
    PreparedMesh mesh = prepared(file, how, field);
    fields_[field] = parse_line(one_line(to_json(mesh.mesh)));
    meshes_.push_back({field, std::move(file), std::move(mesh), std::nullopt});
  }
}

void FileMeshes::tell(std::ostream& err) const {
  for (const Mesh& mesh : meshes_) {
    for (const std::string& line : reading_of(mesh.file)) err << mesh.file.name << ": " << line << '\n';
    for (const std::string& line : mesh.prepared.done) err << mesh.file.name << ": " << line << '\n';
  }
}

const std::vector<std::string>& FileMeshes::hints_of(const Mesh& mesh) const {
  if (!mesh.hints) mesh.hints = hints_of_merging(mesh.file, how_);
  return *mesh.hints;
}

void FileMeshes::add_to(Json& line) const {
  const Json places =
      meshes_.size() == 1 ? places_in_file(meshes_[0].file, meshes_[0].prepared, line.at("truth")) : Json();
  if (!places.empty()) line["places"] = places;
  for (const Mesh& mesh : meshes_) {
    Json told = Json::object();
    if (!mesh.prepared.done.empty()) told["done"] = mesh.prepared.done;
    if (places.contains("open_edge") && !hints_of(mesh).empty()) told["hints"] = hints_of(mesh);
    if (told.empty()) continue;
    Json& member = line["meshes"][mesh.field];
    member["file"] = mesh.file.name;
    member.update(told);
  }
}

std::optional<InvalidInput> FileMeshes::in_file(const InvalidInput& refused) const {
  for (const Mesh& mesh : meshes_) {
    auto told = audit::in_file(mesh.file, mesh.prepared, mesh.field, refused);
    if (!told) continue;
    std::string rule = told->rule();
    if (refused.rule().starts_with("closed:")) {
      for (const std::string& hint : hints_of(mesh)) rule += "; " + hint;
    }
    return InvalidInput(told->field(), rule);
  }
  return std::nullopt;
}

}  // namespace touchstone::program
