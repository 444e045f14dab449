// SPDX-License-Identifier: Apache-2.0
#include "program/file_meshes.h"

#include <ostream>
#include <utility>

#include "audit/meshes/in_file.h"
#include "program/names.h"

namespace touchstone::program {
FileMeshes::FileMeshes(const std::vector<std::string>& named, const Preparation& how) : how_(how) {
  for (const std::string& word : named) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0) throw UsageError("--mesh: expected field=FILE, got " + word);
    const std::string field = word.substr(0, equals);
    if (fields_.contains(field)) throw UsageError("--mesh: " + field + " is given twice");
    MeshFile file = read_mesh_file(word.substr(equals + 1));
    PreparedMesh mesh = prepared(file, how, field);
    written_[field] = to_json(mesh.mesh);
    fields_[field] = parse_line(one_line(written_[field]));
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
