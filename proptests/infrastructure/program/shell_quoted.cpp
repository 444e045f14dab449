// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "audit/shell_quoted.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// What the program says to type in a shell.
namespace touchstone::proptests::shell_quoted_tests {
namespace {

/// What a shell makes of a line.
std::string said_by_shell(const std::string& line) {
  const TextFile script("script.sh", line + "\n");
  FILE* const pipe = popen((std::string("sh ") + script.path()).c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string said;
  char piece[4096];
  for (std::size_t n; (n = fread(piece, 1, sizeof piece, pipe)) > 0;) said.append(piece, n);
  REQUIRE(pclose(pipe) == 0);
  return said;
}

}  // namespace

TEST_CASE("shell_quoted: a word quoted for a shell is that word") {
  for (const std::string word :
       {"plain", "", "two words", "it's", "'", "$HOME `id` \"x\" \\ !", "a\nb %d '\\n", "~/x", "*"}) {
    INFO(word);
    CHECK(said_by_shell("printf '%s' " + shell_quoted(word)) == word);
  }
  CHECK(shell_quoted("a\nb\tc").find_first_of("\n\t") == std::string::npos);
  CHECK(shell_quoted("build/release/engines/geos") == "build/release/engines/geos");
}

}  // namespace touchstone::proptests::shell_quoted_tests
