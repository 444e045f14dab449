// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <vector>

#include "fuzz/driver/target.h"

namespace {

/// Bytes of an input: ten numbers, or eighty where there are lists.
const char* longest() {
  std::vector<double> numbers;
  touchstone::fuzz::target().decode({}, numbers);
  return touchstone::fuzz::target().layout(numbers).lists.empty() ? "-max_len=80" : "-max_len=640";
}

}  // namespace

/// libFuzzer's options where the command line does not name them. Its own start with short inputs, of which no number can be read.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  static std::vector<char*> arguments(*argv, *argv + *argc);
  for (const char* option : {longest(), "-len_control=0"}) {
    const std::size_t name = std::strchr(option, '=') + 1 - option;
    bool given = false;
    for (const char* argument : arguments) given = given || std::strncmp(argument, option, name) == 0;
    if (!given) arguments.push_back(const_cast<char*>(option));
  }
  *argc = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  *argv = arguments.data();
  return 0;
}
