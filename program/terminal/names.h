// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "audit/engines/engine.h"
#include "audit/engines/notes.h"
#include "program/terminal/exit_codes.h"

/// Names on the command line: of operations, engines and files.
namespace touchstone::program {

/// Timeout in seconds for one answer of an engine.
inline constexpr double usual_timeout = 5;

/// The command to ask an engine about its findings again. The program is named by its path if it was called by one, so
/// that the command works where this one was typed.
Repeat repeat_of(const std::string& program, const std::string& engine, double timeout);

/// The command that starts this very program as an engine: its path and --serve.
std::string own_engine_command();

/// Throws UsageError if all of them are methods, which engines are never asked.
void require_asked_of_engines(const std::vector<const Operation*>& operations);

/// An engine that has the operation; nullptr if the command is empty. Throws EngineError.
std::unique_ptr<Engine> engine_for(const Operation& operation, const std::string& command, double timeout,
                                   EngineNotes& notes);

/// Throws UsageError naming the unknown name and the nearest known ones. Duplicates count once.
const Operation& operation_named(const std::string& name);
std::vector<const Operation*> operations_named(const std::string& names);
std::vector<std::string> split(const std::string& names);

/// True for "-" in place of a file name. Text for people is then written to standard error.
bool is_standard_output(const std::string& file);
/// Opens a file that will be written at the end of a long run, so that a wrong name is reported before. Empty: nothing
/// to do. "-" is standard output. Throws UsageError naming the option.
void require_writable(const std::string& option, const std::string& file);
/// Replaces the file atomically: written next to it and renamed. A file that is not regular (a device, a pipe) is
/// written directly.
void write_file(const std::string& option, const std::string& file, const std::string& text);

/// A file opened for reading. Throws UsageError, which begins with the option, if any, and the name.
std::ifstream opened_to_read(const std::string& file, const std::string& option = "");
/// The entire text. Refuses devices as well: they may have no end.
std::string text_of_file(const std::string& file, const std::string& option = "");

/// The prefix of every complaint about a line.
std::string place(const std::string& file, std::uint64_t line);

}  // namespace touchstone::program
