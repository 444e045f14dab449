// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "audit/uses.h"

/// Functions that differ between systems, apart from processes (engines/process.h). One of the files
/// platform_posix.cpp and platform_windows.cpp is compiled. Text for the system is UTF-8.
namespace touchstone::audit {

/// A main program calls this first. Then files and standard streams hold the bytes that are written, where Windows
/// would end lines with "\r\n", and a process that crashes opens no window.
void prepare_program();

enum class Stream { input, output, error };

/// True for a terminal that obeys escape sequences.
bool is_terminal(Stream stream);

/// The path that a text names. libstdc++ for Windows takes a text for UTF-8 only if its type says so.
inline std::filesystem::path path_of(const std::string& text) { return std::u8string(text.begin(), text.end()); }

/// Opens a file that processes do not inherit. Returns its descriptor, or -1 and sets errno.
int open_to_read(const std::string& file);

bool can_write_into(const std::string& directory);

/// A number that no other running process has.
std::string process_number();

/// The path of the running program; empty if it cannot be read.
std::string own_path();

/// Text as one word of a command that Process runs.
std::string command_word(const std::string& text);

}  // namespace touchstone::audit
