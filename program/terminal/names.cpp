// SPDX-License-Identifier: Apache-2.0
#include "program/terminal/names.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "audit/engines/notes.h"
#include "audit/engines/protocol.h"
#include "audit/platform.h"
#include "audit/shell_quoted.h"
#include "catalogue/codec/did_you_mean.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/expected.h"
#include "catalogue/operation/probes/synonyms.h"

namespace touchstone::program {

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
  std::vector<std::string> known;
  for (const Operation* operation : all_operations()) known.push_back(operation->name());
  std::string hint = did_you_mean(name, known);
  if (hint.empty()) {
    if (const std::string why = why_not_computed(name); !why.empty()) hint = "; " + why;
    std::string nearest;
    for (const std::string& other : nearest_operations(name, 3))
      nearest += (nearest.empty() ? "; nearest by words: " : ", ") + other;
    hint += nearest + "; `touchstone ops` lists all";
  }
  throw UsageError("operation " + excerpt(name, most_of_a_key) + ": no operation of the catalogue" + hint);
}

std::vector<const Operation*> operations_named(const std::string& names) {
  if (names == "all") return all_operations();
  std::vector<const Operation*> operations;
  for (const std::string& name : split(names)) {
    const Operation* operation = &operation_named(name);
    if (std::find(operations.begin(), operations.end(), operation) == operations.end()) operations.push_back(operation);
  }
  if (operations.empty()) throw UsageError("--ops: at least one operation, or all");
  return operations;
}

std::ifstream opened_to_read(const std::string& file, const std::string& option) {
  errno = 0;
  std::ifstream opened(file, std::ios::binary);
  int error = opened ? 0 : errno;
  std::error_code unknown;
  if (opened && std::filesystem::is_directory(path_of(file), unknown))
    error = EISDIR;  // a directory opens, and holds no text
  if (!opened || error != 0)
    throw UsageError((option.empty() ? "" : option + " ") + file + ": cannot be read: " + why_of(error));
  return opened;
}

std::string text_of_file(const std::string& file, const std::string& option) {
  std::ifstream opened = opened_to_read(file, option);
  std::error_code unknown;
  if (std::filesystem::is_character_file(path_of(file), unknown) ||
      std::filesystem::is_block_file(path_of(file), unknown))
    throw UsageError((option.empty() ? "" : option + " ") + file + ": cannot be read: is a device");
  return std::string(std::istreambuf_iterator<char>(opened), {});
}

bool is_standard_output(const std::string& file) { return file == "-"; }

void require_asked_of_engines(const std::vector<const Operation*>& operations) {
  const auto is_implementation = [](const Operation* operation) { return operation->metadata().is_implementation(); };
  if (std::all_of(operations.begin(), operations.end(), is_implementation))
    throw UsageError("--engine: " + why_never_asked(*operations.front()));
}

std::unique_ptr<Engine> engine_for(const Operation& operation, const std::string& command, double timeout,
                                   EngineNotes& notes) {
  if (command.empty()) return nullptr;
  require_asked_of_engines({&operation});
  std::unique_ptr<Engine> engine = pipe_engine(command, timeout, nullptr, &notes);
  if (engine->supports(operation.name())) return engine;
  throw EngineError(engine->declaration().engine + ": it does not declare " + operation.name() + notes.of_first_line());
}

Repeat repeat_of(const std::string& program, const std::string& engine, double timeout) {
  Repeat repeat;
  if (engine.empty()) return repeat;
  if (path_of(program).has_parent_path()) repeat.program = shell_quoted(program);
  if (engine != own_engine_command()) repeat.options = "--engine " + shell_quoted(engine);
  if (timeout != usual_timeout)
    repeat.options += (repeat.options.empty() ? "" : " ") + ("--timeout " + decimal(timeout));
  return repeat;
}

void require_writable(const std::string& option, const std::string& file) {
  if (file.empty() || is_standard_output(file)) return;
  std::error_code error;
  const bool was_there = std::filesystem::exists(path_of(file), error);
  errno = 0;
  if (!std::ofstream(file, std::ios::app))
    throw UsageError(option + " " + file + ": cannot be written: " + why_of(errno));
  if (!was_there) std::filesystem::remove(path_of(file), error);
}

void write_file(const std::string& option, const std::string& file, const std::string& text) {
  if (file.empty()) return;
  if (is_standard_output(file)) {
    std::cout << text << std::flush;
    return;
  }
  errno = 0;
  std::error_code error;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path_of(file), error);
  const bool is_special =
      std::filesystem::exists(path_of(file), error) && !std::filesystem::is_regular_file(path_of(file), error);
  const std::string made = is_special ? file : target.string() + "." + process_number();
  std::ofstream opened(made);
  if (!(opened << text << std::flush)) throw UsageError(option + " " + file + ": cannot be written: " + why_of(errno));
  opened.close();
  if (made == file) return;
  std::filesystem::rename(path_of(made), target, error);
  if (error) throw UsageError(option + " " + file + ": cannot be written: " + error.message());
}

std::string place(const std::string& file, std::uint64_t line) {
  const std::string name = file.empty() || file == "-" ? "standard input" : excerpt(file, 1000);
  return "touchstone: " + name + ": line " + std::to_string(line) + ": ";
}

}  // namespace touchstone::program
