// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "program/program.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

/// The program as it is called, inside this process.
namespace touchstone::proptests {

struct Called {
  int code = 0;
  std::string out, err;
};

inline Called called(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "touchstone");
  std::ostringstream out, err;
  auto* const previous_out = std::cout.rdbuf(out.rdbuf());
  auto* const previous_err = std::cerr.rdbuf(err.rdbuf());
  Called call;
  call.code = run_program(static_cast<int>(arguments.size()), arguments.data());
  std::cout.rdbuf(previous_out);
  std::cerr.rdbuf(previous_err);
  call.out = out.str(), call.err = err.str();
  return call;
}

inline void require_refused(const Called& call, int code, const std::string& words) {
  INFO(call.err);
  CHECK(call.code == code);
  CHECK_THAT(call.err, StartsWith("touchstone: ") && ContainsSubstring(words));
  CHECK(std::count(call.err.begin(), call.err.end(), '\n') == 1);
}

/// A file of this process that is gone afterwards.
class TextFile {
 public:
  TextFile(const std::string& name, const std::string& text)
      : path_((std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_" + name)).string()) {
    std::ofstream(path_) << text;
  }
  ~TextFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  const char* path() const { return path_.c_str(); }

 private:
  std::string path_;
};

}  // namespace touchstone::proptests
