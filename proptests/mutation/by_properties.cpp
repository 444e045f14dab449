// SPDX-License-Identifier: Apache-2.0
// The agreement suite run on the mutants in TOUCHSTONE_MUTANTS: every property on the baseline, then on each surviving
// mutant. Once none survives, the remaining properties are skipped.
#include <cstdlib>

#include "proptests/mutation/surviving.h"
#include "proptests/property.h"

namespace touchstone::proptests {

void demand(const std::string& name, const std::function<std::string()>& complaint) {
  static mutation::Surviving surviving(std::getenv("TOUCHSTONE_MUTANTS"));
  if (surviving.none()) return;
  INFO(name);
  CHECK(surviving.run(complaint));
}

}  // namespace touchstone::proptests
