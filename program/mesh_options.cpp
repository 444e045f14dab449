// SPDX-License-Identifier: Apache-2.0
#include "program/mesh_options.h"

#include <iostream>
#include <memory>

#include "program/commands.h"
#include "program/file_meshes.h"

namespace touchstone::program {

void add_mesh(CLI::App& program, std::function<int()>& action) {
  auto* command =
      program.add_subcommand("mesh", "What a mesh is, what is wrong with it, where, and what would mend it");
  auto options = std::make_shared<MeshCommand>();
  command->add_option("file", options->files, "OBJ, PLY, OFF or STL files; several make a table")->required();
  add_preparation(*command, options->preparation);
  command->add_option("--repair", options->repair,
                      "Write the mesh with what is certain mended into this file (.obj, .off or .ply)");
  command->add_option("--page", options->page,
                      "Write an HTML page with a picture into this file; - is standard output");
  command->add_flag("--json", options->json, "A line of JSON for each file");
  command->callback([=, &action] { action = [=] { return mesh_command(*options, std::cout, std::cerr); }; });
}

}  // namespace touchstone::program
