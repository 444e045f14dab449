// SPDX-License-Identifier: Apache-2.0
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// `touchstone deck`: what it refuses; proptests/opened_pages.py opens the page that it writes.
namespace touchstone::proptests::deck_command_tests {

TEST_CASE("deck: needs a page, and names the scene that is not there, before anything is asked") {
  CHECK_THAT(called({"deck"}).err, ContainsSubstring("--page"));
  const Called none = called({"deck", "--page", "-", "--scenes", "no/such/folder"});
  CHECK(none.code == bad_usage);
  CHECK_THAT(none.err, ContainsSubstring("--scenes no/such/folder/projectile.json"));
}

}  // namespace touchstone::proptests::deck_command_tests
