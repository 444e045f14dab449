// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>

#include "audit/platform.h"
#include "audit/shell_quoted.h"

namespace touchstone::audit {

void prepare_program() {}

bool is_terminal(Stream stream) {
  return isatty(stream == Stream::input ? STDIN_FILENO : stream == Stream::output ? STDOUT_FILENO : STDERR_FILENO) != 0;
}

int open_to_read(const std::string& file) { return open(file.c_str(), O_RDONLY | O_CLOEXEC); }

bool can_write_into(const std::string& directory) { return access(directory.c_str(), W_OK) == 0; }

std::string process_number() { return std::to_string(getpid()); }

std::string own_path() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "" : self.string();
}

std::string command_word(const std::string& text) { return shell_quoted(text); }

}  // namespace touchstone::audit
