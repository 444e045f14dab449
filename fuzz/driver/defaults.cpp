// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "fuzz/driver/target.h"

namespace {

/// An input of the greatest useful length: all numbers and enumerators of a question after the first byte, and at least
/// 80 bytes, which families draw from; eighty numbers if there are lists, more if a question holds a mesh.
std::string longest() {
  const auto& operation = touchstone::fuzz::target().operation();
  if (!operation.question_shape().fixed) return operation.metadata().cost > 10 ? "-max_len=1600" : "-max_len=640";
  std::size_t most = 80;
  for (const auto& zeros : operation.zeros_of_alternatives())
    most = std::max(most, 1 + sizeof(double) * (zeros.numbers.size() + zeros.words.size()));
  return "-max_len=" + std::to_string(most);
}

}  // namespace

/// Takes the operation from the command line, and sets libFuzzer's options that the command line does not set.
/// libFuzzer itself would start with short inputs, from which no number can be read.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  touchstone::fuzz::choose_target(*argc, *argv);
  static std::vector<char*> arguments(*argv, *argv + *argc);
  static std::vector<std::string> options{longest(), "-len_control=0"};
  for (std::string& option : options) {
    const std::size_t name = option.find('=') + 1;
    bool given = false;
    for (const char* argument : arguments) given = given || option.compare(0, name, argument, 0, name) == 0;
    if (!given) arguments.push_back(option.data());
  }
  *argc = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  *argv = arguments.data();
  return 0;
}
