// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "audit/meshes/prepared.h"
#include "catalogue/codec/json.h"
#include "catalogue/operation/operation.h"
#include "geometry/invalid_input.h"
#include "program/terminal/uses.h"

namespace touchstone::program {

/// The meshes that a command line gives for fields of every question.
class FileMeshes {
 public:
  /// named: "field=FILE", or FILE if the operation has exactly one mesh field. Throws UsageError for other words and a
  /// field named twice, and InvalidInput like reading and preparing.
  FileMeshes(const std::vector<std::string>& named, const Preparation& how, const Operation* operation = nullptr);

  /// The fields with their meshes, in the form of a parsed line.
  const Json& fields() const { return fields_; }
  /// The same, as the program writes them.
  const Json& written() const { return written_; }
  /// Prints how they were read and prepared, one line each.
  void tell(std::ostream& err) const;
  /// Adds the members `places`, for one mesh, and `meshes`, the preparation and hints, if there are any.
  void add_to(Json& line) const;
  /// Replaces the meshes by the names of their files.
  void name_in(Json& input) const;
  /// The file that gives a field.
  std::string file_of(const std::string& field) const;
  /// Turns a refusal of one of the fields into one of its file, with hints.
  std::optional<InvalidInput> in_file(const InvalidInput& refused) const;

 private:
  struct Mesh {
    std::string field;
    MeshFile file;
    PreparedMesh prepared;
    mutable std::optional<std::vector<std::string>> hints;
  };
  const std::vector<std::string>& hints_of(const Mesh& mesh) const;

  Preparation how_;
  std::vector<Mesh> meshes_;
  Json fields_ = Json::object(), written_ = Json::object();
};

}  // namespace touchstone::program
