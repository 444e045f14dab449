// SPDX-License-Identifier: Apache-2.0
#include <touchstone/oracle/certificates/check.h>

#include <cstdio>

int main() {
  const auto why = touchstone::certify::refuse_text("not a claim");
  if (!why) std::puts("the checker accepts what is no claim");
  return why ? 0 : 1;
}
