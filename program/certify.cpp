// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "oracle/certificates/check.h"
#include "program/commands.h"
#include "program/program.h"

namespace touchstone::program {

int certify_command(const std::string& file, std::ostream& out, std::ostream& err) {
  std::uint64_t refused = 0, without = 0;
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const std::uint64_t lines = each_line(file, [&](std::uint64_t number, const std::string& text) {
    if (const auto reason = certify::refuse_text(text, folder)) {
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
