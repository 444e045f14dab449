// SPDX-License-Identifier: Apache-2.0
#include "proptests/selftests/planted.h"

#include <cstdlib>

namespace {
int chosen() {
  const char* number = std::getenv("TOUCHSTONE_PLANTED");
  return number == nullptr ? 0 : std::atoi(number);
}
}  // namespace

const int touchstone_planted = chosen();
