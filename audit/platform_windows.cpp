// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <cstdio>
#include <cstdlib>

#include "audit/platform.h"

namespace touchstone::audit {

void prepare_program() {
  _fmode = _O_BINARY;
  for (FILE* stream : {stdin, stdout, stderr}) _setmode(_fileno(stream), _O_BINARY);
  SetErrorMode(GetErrorMode() | SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
  if (_isatty(_fileno(stdout)) != 0 || _isatty(_fileno(stderr)) != 0) SetConsoleOutputCP(CP_UTF8);
}

bool is_terminal(Stream stream) {
  const HANDLE handle = GetStdHandle(stream == Stream::input    ? STD_INPUT_HANDLE
                                     : stream == Stream::output ? STD_OUTPUT_HANDLE
                                                                : STD_ERROR_HANDLE);
  DWORD mode = 0;
  if (GetConsoleMode(handle, &mode) == 0) return false;
  return stream == Stream::input || SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

int open_to_read(const std::string& file) { return _open(file.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT); }

/// By a file that vanishes with its handle: the rights of a directory say less.
bool can_write_into(const std::string& directory) {
  const std::string name = directory + "/touchstone." + process_number();
  const HANDLE made = CreateFileA(name.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW,
                                  FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (made == INVALID_HANDLE_VALUE) return false;
  CloseHandle(made);
  return true;
}

std::string process_number() { return std::to_string(GetCurrentProcessId()); }

std::string own_path() {
  std::string path(1 << 15, '\0');
  const DWORD size = GetModuleFileNameA(nullptr, path.data(), static_cast<DWORD>(path.size()));
  if (size == path.size()) return "";
  path.resize(size);
  return path;
}

/// As programs split their command line: a quotation mark is escaped by a backslash, and so are backslashes before it.
std::string command_word(const std::string& text) {
  if (!text.empty() && text.find_first_of(" \t\n\v\"") == std::string::npos) return text;
  std::string quoted = "\"";
  std::size_t backslashes = 0;
  for (const char c : text) {
    if (c == '"') quoted.append(backslashes + 1, '\\');
    backslashes = c == '\\' ? backslashes + 1 : 0;
    quoted += c;
  }
  return quoted.append(backslashes, '\\') + '"';
}

}  // namespace touchstone::audit
