// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <iostream>

#include "program/terminal/names.h"

namespace touchstone::program {

/// Calls visit(line number, text) for each line of a file, or of standard input for "-" or "". Throws UsageError if it
/// cannot be opened. Returns the number of lines that are not blank.
template <class Visit>
std::uint64_t each_line(const std::string& file, const Visit& visit) {
  std::ifstream opened;
  const bool standard_input = file.empty() || file == "-";
  if (!standard_input) opened = opened_to_read(file);
  std::istream& in = standard_input ? std::cin : opened;
  std::uint64_t number = 0, filled = 0;
  for (std::string text; std::getline(in, text);) {
    ++number;
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    ++filled;
    visit(number, text);
  }
  return filled;
}

}  // namespace touchstone::program
