// SPDX-License-Identifier: Apache-2.0
#include "program/commands.h"
#include "program/names.h"
#include "program/program.h"
#include "simulate/run.h"

namespace touchstone::program {

int simulate_command(const std::string& file, std::uint64_t steps, std::ostream& out) {
  const std::string text = text_of_file(file);
  try {
    simulate::run(simulate::read_scene(parse_line(text)), steps, out);
  } catch (const InvalidInput& refused) {
    throw UsageError(file + ": " + refused.what());
  }
  return nothing_found;
}

}  // namespace touchstone::program
