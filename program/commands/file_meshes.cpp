// SPDX-License-Identifier: Apache-2.0
#include "program/commands/file_meshes.h"

#include <algorithm>
#include <ostream>
#include <utility>

#include "audit/meshes/in_file.h"
#include "program/terminal/names.h"

namespace touchstone::program {
namespace {

/// The fields that are meshes in every alternative of a question.
std::vector<std::string> mesh_fields(const Shape& question) {
  std::vector<std::string> fields;
  for (const Shape::Part& part : question.parts) {
    if (question.kind == Shape::Kind::choice) {
      for (const std::string& field : mesh_fields(*part.shape))
        if (std::find(fields.begin(), fields.end(), field) == fields.end()) fields.push_back(field);
    } else if (part.shape->form == Form::mesh) {
      fields.push_back(part.name);
    }
  }
  return fields;
}

/// The field and the file that a word names.
std::pair<std::string, std::string> field_and_file(const std::string& word, const Operation* operation) {
  const std::vector<std::string> fields =
      operation == nullptr ? std::vector<std::string>{} : mesh_fields(operation->question_shape());
  const std::size_t equals = word.find('=');
  if (equals != std::string::npos && equals != 0) return {word.substr(0, equals), word.substr(equals + 1)};
  if (fields.size() == 1 && equals == std::string::npos) return {fields[0], word};
  std::string rule = "expected field=FILE";
  if (operation != nullptr) {
    std::string all;
    for (const std::string& field : fields) all += (all.empty() ? " with field " : " or ") + field;
    rule = fields.empty() ? std::string(operation->name()) + " has no field that is a mesh" : rule + all;
  }
  throw UsageError("--mesh: " + rule + ", got " + word);
}

}  // namespace

FileMeshes::FileMeshes(const std::vector<std::string>& named, const Preparation& how, const Operation* operation)
    : how_(how) {
  for (const std::string& word : named) {
    const auto [field, name] = field_and_file(word, operation);
    if (fields_.contains(field)) throw UsageError("--mesh: " + field + " is given twice");
    MeshFile file = read_mesh_file(name);
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
    Json details = Json::object();
    if (!mesh.prepared.done.empty()) details["done"] = mesh.prepared.done;
    if (places.contains("open_edge") && !hints_of(mesh).empty()) details["hints"] = hints_of(mesh);
    if (details.empty()) continue;
    Json& member = line["meshes"][mesh.field];
    member["file"] = mesh.file.name;
    member.update(details);
  }
}

void FileMeshes::name_in(Json& input) const {
  for (const Mesh& mesh : meshes_) input[mesh.field] = mesh.file.name;
}

std::string FileMeshes::file_of(const std::string& field) const {
  const auto has = [&](const Mesh& mesh) { return mesh.field == field; };
  return std::find_if(meshes_.begin(), meshes_.end(), has)->file.name;
}

std::optional<InvalidInput> FileMeshes::in_file(const InvalidInput& refused) const {
  for (const Mesh& mesh : meshes_) {
    auto details = audit::in_file(mesh.file, mesh.prepared, mesh.field, refused);
    if (!details) continue;
    std::string rule = details->rule();
    if (refused.rule().starts_with("closed:")) {
      for (const std::string& hint : hints_of(mesh)) rule += "; " + hint;
    }
    return InvalidInput(details->field(), rule);
  }
  return std::nullopt;
}

}  // namespace touchstone::program
