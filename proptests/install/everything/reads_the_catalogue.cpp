// SPDX-License-Identifier: Apache-2.0
#include <touchstone/catalogue/operation/operation.h>

#include <cstdio>

int main() {
  const auto* operation = touchstone::catalogue::find_operation("orientation");
  if (operation == nullptr) return 1;
  std::printf("%s, deck p. %s\n", operation->metadata().name, operation->metadata().pages);
  return 0;
}
