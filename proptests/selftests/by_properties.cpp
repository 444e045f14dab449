// SPDX-License-Identifier: Apache-2.0
// The agreement suite, asked of the mutants in TOUCHSTONE_MUTANTS: every property without a mutant, then with each that
// is alive. When none is, the rest is not asked.
#include <cstdlib>

#include "proptests/property.h"
#include "proptests/selftests/alive.h"

namespace touchstone::proptests {

void demand(const std::string& name, const std::function<std::string()>& complaint) {
  static selftests::Alive alive(std::getenv("TOUCHSTONE_MUTANTS"));
  if (alive.none()) return;
  INFO(name);
  CHECK(alive.ask(complaint));
}

}  // namespace touchstone::proptests
