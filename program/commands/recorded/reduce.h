// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "audit/meshes/prepared.h"
#include "program/terminal/names.h"

namespace touchstone::program {

struct ReduceCommand {
  std::string program = "touchstone";  ///< as it was called
  std::string operation, file;         ///< empty file: standard input, or none where meshes are every field
  std::string engine;                  ///< command; empty: the textbook formula
  std::string with = "reference";      ///< or "reference,float"
  std::string until;                   ///< command that decides; empty: the judge does
  double timeout = usual_timeout;
  bool any_answer = false, allow_degenerate = false, allow_invalid = false;
  double seconds = 0;
  int jobs = 0;           ///< 0: as many as the machine has
  std::string directory;  ///< empty: nothing but standard output
  std::vector<std::string> meshes;
  Preparation preparation;
  bool wkt = false, geojson = false;
};

/// The smallest question found that fails as that of the file does, a line of JSON: op, input, what it was reduced from
/// and to, the truth and what was answered.
int reduce_command(const ReduceCommand& command, std::ostream& out, std::ostream& err);

}  // namespace touchstone::program
