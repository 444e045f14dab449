// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <fstream>
#include <iterator>

#include "catalogue/codec/expected.h"
#include "program/commands.h"
#include "program/program.h"
#include "simulate/run.h"

namespace touchstone::program {

int simulate_command(const std::string& file, std::uint64_t steps, std::ostream& out) {
  errno = 0;
  std::ifstream opened(file);
  if (!opened) throw UsageError(file + ": cannot be read: " + why_of(errno));
  const std::string text(std::istreambuf_iterator<char>(opened), {});
  try {
    simulate::run(simulate::read_scene(parse_line(text)), steps, out);
  } catch (const InvalidInput& refused) {
    throw UsageError(file + ": " + refused.what());
  }
  return nothing_found;
}

}  // namespace touchstone::program
