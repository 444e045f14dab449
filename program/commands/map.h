// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "program/terminal/names.h"

namespace touchstone::program {

/// `touchstone map OP... [--out DIR] [--jobs N]`: a failure map of each operation as OP.png (reference next to robust)
/// and OP.html (the same with legend); prints the names of the files and one line of counts each. Throws UsageError for
/// an unknown operation or a directory that cannot be written. Jobs 0: as many as the machine has. With an engine's
/// command a third map shows its answers, on a grid of its own number type. Returns 1 if a pixel is a finding,
/// otherwise 0.
struct MapCommand {
  std::string program = "touchstone";
  std::vector<std::string> operations;
  std::string directory = "maps";
  bool binary32 = false;
  int jobs = 0;
  std::string engine;
  double timeout = usual_timeout;
};
int run_map(const MapCommand& command);

}  // namespace touchstone::program
