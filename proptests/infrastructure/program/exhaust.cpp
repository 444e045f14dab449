// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "catalogue/operation/operation.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

namespace touchstone::proptests::exhaust_tests {

TEST_CASE("exhaust: the hash of the decisions changes with a decision") {
  // Worked again from its definition, out of the full examination.
  const Operation& operation = *find_operation("orientation");
  const auto count = operation.count_decisions(2, 0, 64);
  REQUIRE(count);
  const std::vector<std::string> words{"left", "on", "right"};
  std::uint64_t hash = 0;
  for (std::uint64_t i = 0; i < 64; ++i) {
    const std::string outcome = operation.examine(operation.on_grid(2, i))->outcome();
    const auto word = static_cast<std::uint64_t>(std::find(words.begin(), words.end(), outcome) - words.begin());
    std::uint64_t z = i * 4 + word;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    hash += z ^ (z >> 31);
  }
  CHECK(count->hash == hash);
}

}  // namespace touchstone::proptests::exhaust_tests
