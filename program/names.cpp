// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>

#include "catalogue/codec/excerpt.h"
#include "program/commands.h"

namespace touchstone::audit {

std::vector<std::string> split(const std::string& names) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= names.size() && !names.empty();) {
    const std::size_t comma = std::min(names.find(',', at), names.size());
    parts.push_back(names.substr(at, comma - at));
    at = comma + 1;
  }
  return parts;
}

const Operation& operation_named(const std::string& name) {
  if (const Operation* operation = find_operation(name)) return *operation;
  std::string known;
  for (const Operation* operation : catalogue()) known += (known.empty() ? "" : ", ") + operation->name();
  throw UsageError("operation " + name + ": one of " + known);
}

std::vector<const Operation*> operations_named(const std::string& names) {
  if (names == "all") return catalogue();
  std::vector<const Operation*> operations;
  for (const std::string& name : split(names)) {
    const Operation* operation = &operation_named(name);
    if (std::find(operations.begin(), operations.end(), operation) == operations.end()) operations.push_back(operation);
  }
  if (operations.empty()) throw UsageError("--ops: at least one operation, or all");
  return operations;
}

void require_writable(const std::string& option, const std::string& file) {
  if (!file.empty() && !std::ofstream(file, std::ios::app))
    throw UsageError(option + " " + file + ": a file that can be written");
}

void write_file(const std::string& option, const std::string& file, const std::string& text) {
  if (file.empty()) return;
  std::ofstream opened(file);
  if (!(opened << text << std::flush)) throw UsageError(option + " " + file + ": a file that can be written");
}

std::string place(const std::string& file, std::uint64_t line) {
  const std::string name = file.empty() || file == "-" ? "standard input" : excerpt(file, 1000);
  return "touchstone: " + name + ": line " + std::to_string(line) + ": ";
}

}  // namespace touchstone::audit
