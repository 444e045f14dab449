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

/// The meshes that a command line names for fields of every question.
class FileMeshes {
 public:
  /// named: "field=FILE", or FILE where the operation has one field that is a mesh. Throws UsageError for other words
  /// and a field named twice, InvalidInput as reading and preparing do.
  FileMeshes(const std::vector<std::string>& named, const Preparation& how, const Operation* operation = nullptr);

  /// The fields with their meshes, as a parsed line has them.
  const Json& fields() const { return fields_; }
  /// The same, as the program writes them.
  const Json& written() const { return written_; }
  /// What was read and done, on lines of their own.
  void tell(std::ostream& err) const;
  /// The members `places`, of one mesh, and `meshes`, what was done and would help, where there are such.
  void add_to(Json& line) const;
  /// Writes the names of the files for the meshes.
  void name_in(Json& input) const;
  /// The file of a field that one of them is for.
  std::string file_of(const std::string& field) const;
  /// A refusal of one of the fields as one of its file, with what would help.
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
