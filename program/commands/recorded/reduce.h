// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "audit/meshes/prepared.h"
#include "program/terminal/names.h"

namespace touchstone::program {

struct ReduceCommand {
  std::string program = "touchstone";  ///< the name by which it was called
  std::string operation, file;         ///< empty file: standard input, or none if meshes give every field
  std::string engine;                  ///< command; empty: the textbook formula
  std::string with = "reference";      ///< or "reference,float"
  std::string until;                   ///< command that decides; empty: the judge does
  double timeout = usual_timeout;
  bool any_answer = false, allow_degenerate = false, allow_invalid = false;
  double seconds = 0;
  int jobs = 0;           ///< 0: as many as the machine has
  std::string directory;  ///< empty: only standard output
  std::vector<std::string> meshes;
  Preparation preparation;
  bool wkt = false, geojson = false;
};

/// Finds the smallest question that fails like that of the file, and prints a line of JSON: op, input, its size before
/// and after, the truth and the answer.
int reduce_command(const ReduceCommand& command, std::ostream& out, std::ostream& err);

}  // namespace touchstone::program
