// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <iostream>

#include "audit/text/geometries.h"
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

/// Calls visit(number of the first line, text) for each JSON text of a file, each of one line or more, like each_line
/// for lines.
template <class Visit>
std::uint64_t each_json_text(const std::string& file, const Visit& visit) {
  std::string text;
  OpenBrackets open;
  std::uint64_t first = 0, texts = 0;
  each_line(file, [&](std::uint64_t number, const std::string& line) {
    if (text.empty()) first = number, ++texts;
    text += line + "\n";
    open.read(line);
    if (!open.none()) return;
    visit(first, text);
    text.clear(), open = {};
  });
  if (!text.empty()) visit(first, text);
  return texts;
}

}  // namespace touchstone::program
