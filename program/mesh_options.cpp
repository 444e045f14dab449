// SPDX-License-Identifier: Apache-2.0
#include "program/mesh_options.h"

#include <fmt/format.h>

#include <iostream>
#include <limits>
#include <memory>

#include "audit/meshes/merged.h"
#include "program/commands/commands.h"
#include "program/terminal/exit_codes.h"

namespace touchstone::program {
namespace {

/// A number from 0 to `most`. The parser may have taken a file name for it.
double length_of(const std::string& option, const std::string& text, double most, const std::string& range) {
  double value = 0;
  if (CLI::detail::lexical_cast(text, value) && value >= 0 && value <= most) return value;
  throw UsageError(fmt::format("{}: expected a number {}, got {}; files come before the options", option, range, text));
}

/// Adds --merge, --planar and --cut.
std::vector<CLI::Option*> add_preparation(CLI::App& command, Preparation& how) {
  const auto set_merge = [&how](const std::string& text) {
    const bool alone = text.empty() || text == "true";
    how.merge = alone ? 0 : length_of("--merge", text, most_to_merge, "from 0 to 0.01");
  };
  const auto set_planar = [&how](const std::string& text) {
    how.planar = length_of("--planar", text, std::numeric_limits<double>::max(), "of at least 0");
  };
  const auto set_cut = [&how](const std::string& word) {
    how.cut = word == "fan" ? Preparation::Cut::fan : Preparation::Cut::shortest;
  };
  return {command
              .add_option_function<std::string>(
                  "--merge", set_merge,
                  "Vertices of a mesh file in equal positions are one; with a number T, those nearer than T times the "
                  "size of the mesh (at most 0.01)")
              ->expected(0, 1)
              ->default_str("0"),
          command
              .add_option_function<std::string>("--planar", set_planar,
                                                "Faces of a mesh file whose corners lie at most so far apart across "
                                                "the face, in the file's unit, are taken for planar")
              ->default_str(""),
          command
              .add_option_function<std::string>("--cut", set_cut,
                                                "How faces of a mesh file that are not planar are cut: fan or shortest")
              ->check(CLI::IsMember({"fan", "shortest"}))
              ->default_str("")};
}

}  // namespace

CLI::Option* add_file_meshes(CLI::App& command, std::vector<std::string>& named, Preparation& how) {
  auto* mesh = command.add_option(
      "--mesh", named,
      "field=FILE: that field of every line is the mesh in an OBJ, PLY, OFF, STL, glTF or 3MF file; lines may lack it. "
      "Of two meshes: --mesh a=A.obj --mesh b=B.obj; the field may be left out where there is one");
  mesh->allow_extra_args(false)->default_str("");
  for (CLI::Option* option : add_preparation(command, how)) option->needs(mesh);
  return mesh;
}

void add_mesh(CLI::App& program, std::function<int()>& action) {
  auto* command =
      program.add_subcommand("mesh", "What a mesh is, what is wrong with it, where, and what would mend it");
  auto options = std::make_shared<MeshCommand>();
  command->add_option("file", options->files, "OBJ, PLY, OFF, STL, glTF or 3MF files; several make a table")
      ->required();
  add_preparation(*command, options->preparation);
  command->add_option("--repair", options->repair,
                      "Write the mesh with what is certain mended into this file (.obj, .off, .ply or .stl)");
  command->add_option("--page", options->page,
                      "Write an HTML page with a picture into this file; - is standard output");
  command->add_flag("--json", options->json, "A line of JSON for each file");
  command->callback([=, &action] { action = [=] { return mesh_command(*options, std::cout, std::cerr); }; });
}

}  // namespace touchstone::program
