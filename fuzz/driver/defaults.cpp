// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "fuzz/driver/target.h"

namespace {

/// Bytes of an input: all numbers and words of a question after the first byte, and not fewer than 80, which families
/// draw from; eighty numbers where there are lists, more where one question is a mesh.
std::string longest() {
  const auto& operation = touchstone::fuzz::target().operation();
  if (!operation.question_shape().fixed) return operation.metadata().cost > 10 ? "-max_len=1600" : "-max_len=640";
  std::size_t most = 80;
  for (const auto& zeros : operation.zeros_of_alternatives())
    most = std::max(most, 1 + sizeof(double) * (zeros.numbers.size() + zeros.words.size()));
  return "-max_len=" + std::to_string(most);
}

}  // namespace

/// The operation from the command line, and libFuzzer's options where the command line does not name them. Its own
/// start with short inputs, of which no number can be read.
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
