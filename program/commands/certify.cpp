// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "audit/platform.h"
#include "oracle/certificates/check.h"
#include "program/commands/commands.h"
#include "program/commands/file_meshes.h"
#include "program/terminal/exit_codes.h"

namespace touchstone::program {
namespace {

/// The reason why the claim is not about these meshes or not proved. If its input lacks one of their fields, the mesh
/// is inserted.
std::optional<std::string> refuse_about(const FileMeshes& meshes, const std::string& text) {
  nlohmann::json claim = nlohmann::json::parse(text, nullptr, false);
  if (!claim.is_object() || !claim.contains("input") || !claim["input"].is_object()) return certify::refuse(claim);
  nlohmann::json& input = claim["input"];
  for (const auto& [field, value] : meshes.written().items()) {
    const nlohmann::json mesh = nlohmann::json::parse(one_line(value));
    if (!input.contains(field)) input[field] = mesh;
    if (input[field] != mesh) return "input." + field + " is not the mesh of " + meshes.file_of(field);
  }
  return certify::refuse(claim);
}

}  // namespace

int certify_command(const CertifyCommand& command, std::ostream& out, std::ostream& err) {
  std::uint64_t refused = 0, without = 0;
  const std::string& file = command.file;
  const std::string folder = path_of(file).parent_path().string();
  const FileMeshes meshes(command.meshes, command.preparation);
  const std::uint64_t lines = each_line(file, [&](std::uint64_t number, const std::string& text) {
    const auto reason = command.meshes.empty() ? certify::refuse_text(text, folder) : refuse_about(meshes, text);
    if (number == 1 && reason == "not JSON")
      throw UsageError((file == "-" ? "standard input" : file) +
                       ": line 1: not JSON; certify reads lines as ask and vectors write them");
    if (reason) {
      ++refused;
      err << place(file, number) << *reason << '\n';
    } else if (certify::is_refused_input(text)) {
      ++without;
    }
  });
  out << lines - without << " certificates, " << refused << " refused";
  if (without > 0) out << "; " << without << " refused inputs, which have none";
  out << '\n';
  if (lines == 0) {
    err << place(file, 1) << "line: one JSON object, found an empty file\n";
    return bad_usage;
  }
  return refused > 0 ? findings : nothing_found;
}

}  // namespace touchstone::program
