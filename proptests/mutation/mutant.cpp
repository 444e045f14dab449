// SPDX-License-Identifier: Apache-2.0
#include "proptests/mutation/mutant.h"

#include <cstdlib>

namespace {
int chosen() {
  const char* number = std::getenv("TOUCHSTONE_MUTANT");
  return number == nullptr ? 0 : std::atoi(number);
}
}  // namespace

int touchstone_mutant = chosen();
