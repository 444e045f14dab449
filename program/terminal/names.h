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

/// Seconds that an engine has for one answer.
inline constexpr double usual_timeout = 5;

/// How findings of an engine are asked again. The program is named by its path if it was called by one, so that the
/// line works where this one was typed.
Repeat repeat_of(const std::string& program, const std::string& engine, double timeout);

/// The command that starts this very program as an engine: its path and --serve.
std::string own_engine_command();

/// Throws UsageError where all of them are methods, of which engines are asked none.
void require_asked_of_engines(const std::vector<const Operation*>& operations);

/// An engine that has the operation; nullptr where the command is empty. Throws EngineError.
std::unique_ptr<Engine> engine_for(const Operation& operation, const std::string& command, double timeout,
                                   EngineNotes& notes);

/// Throws UsageError naming what is not known and the nearest that are. A name given twice counts once.
const Operation& operation_named(const std::string& name);
std::vector<const Operation*> operations_named(const std::string& names);
std::vector<std::string> split(const std::string& names);

/// "-", where a file's name is asked for. What people read is then written to standard error.
bool is_standard_output(const std::string& file);
/// Opens a file that will be written at the end of a long run, so that a wrong name is known before. Empty: nothing to
/// do. "-" is standard output. Throws UsageError naming the option.
void require_writable(const std::string& option, const std::string& file);
/// The file is there with all of the text or as it was: written beside its place and renamed. What is no regular file
/// (a device, a pipe) is written as it is.
void write_file(const std::string& option, const std::string& file, const std::string& text);

/// A file that can be read. Throws UsageError, which begins with what was given: the option, or nothing, and the name.
std::ifstream opened_to_read(const std::string& file, const std::string& option = "");
/// All of it. A device is refused as well: it may have no end.
std::string text_of_file(const std::string& file, const std::string& option = "");

/// What stands before every complaint about a line.
std::string place(const std::string& file, std::uint64_t line);

}  // namespace touchstone::program
