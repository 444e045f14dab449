// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// What documents the program comes from the tree of its options.
namespace touchstone::proptests::documentation_tests {
namespace {

std::string said_by(const std::string& shell, const std::string& script) {
  const TextFile file("script", script);
  FILE* const pipe = popen((shell + " " + file.path() + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string said;
  char piece[4096];
  for (std::size_t n; (n = fread(piece, 1, sizeof piece, pipe)) > 0;) said.append(piece, n);
  pclose(pipe);
  return said;
}

bool has(const char* program) {
  return std::system((std::string("command -v ") + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// What bash would offer behind these words, the last of which is being typed.
std::string completed(const std::vector<std::string>& words) {
  std::string script = called({"--completion", "bash"}).out + "\nCOMP_WORDS=(touchstone";
  for (const std::string& word : words) script += " '" + word + "'";
  return said_by("bash",
                 script + ")\nCOMP_CWORD=" + std::to_string(words.size()) + "\n_touchstone\necho ${COMPREPLY[*]}\n");
}

}  // namespace

TEST_CASE("documentation: the manual page has every command and option of the help") {
  const Called man = called({"--man"});
  CHECK(man.code == nothing_found);
  CHECK_THAT(man.out, StartsWith(".TH TOUCHSTONE 1"));
  for (const char* words : {".SS touchstone audit", ".SS touchstone vectors check directory", "\\-\\-families",
                            "Same seed, same questions [1]", ".SH EXIT STATUS", "nested at most 64 deep"})
    CHECK_THAT(man.out, ContainsSubstring(words));
  for (const char* command : {"ops", "ask", "audit", "check-engine", "exhaust", "merge", "certify", "map"}) {
    std::istringstream help(called({command, "--help"}).out);
    for (std::string line; std::getline(help, line);) {
      const std::size_t option = line.find("--");
      if (option == std::string::npos || line.find_first_not_of(' ') != line.find('-')) continue;
      std::string name = line.substr(option, line.find_first_of(" ,", option) - option);
      INFO(command << " " << name);
      for (std::size_t at = 0; (at = name.find('-', at)) != std::string::npos; at += 2) name.insert(at, "\\");
      CHECK(man.out.find(name) != std::string::npos);
    }
  }
}

TEST_CASE("documentation: the help of every command that takes mesh files tells how large they may be") {
  for (const char* command : {"ask", "audit", "certify", "mesh"}) {
    INFO(command);
    CHECK_THAT(called({command, "--help"}).out,
               ContainsSubstring("mesh") && ContainsSubstring("A mesh file is a regular file of at most 256 MiB."));
  }
}

TEST_CASE("documentation: the manual page is right roff") {
  if (!has("groff")) return;  // skipped
  const TextFile page("touchstone.1", called({"--man"}).out);
  CHECK(said_by("sh", std::string("groff -man -Tascii -ww -z ") + page.path() + "\n").empty());
}

TEST_CASE("documentation: bash completes commands, options and names of operations") {
  if (!has("bash")) return;  // skipped
  CHECK(completed({"aud"}) == "audit\n");
  CHECK(completed({"check"}) == "check-engine\n");
  CHECK(completed({"audit", "--fam"}) == "--families\n");
  CHECK(completed({"audit", "--ops", "orient"}) == "orientation\n");
  CHECK(completed({"audit", "--ops", "line_line,orient"}) == "line_line,orientation\n");
  CHECK(completed({"ask", "orient"}) == "orientation\n");
  CHECK(completed({"vectors", "ch"}) == "check\n");
  CHECK(completed({"vectors", "check", "--eng"}) == "--engine\n");
  CHECK(completed({"audit", "--json", "fi"}) == "\n");  // files: bash's own
  CHECK_THAT(called({"--completion", "zsh"}).out, StartsWith("#compdef touchstone\n"));
  require_refused(called({"--completion", "bsh"}), bad_usage,
                  "--completion bsh: expected bash or zsh (did you mean \"bash\"?)");
}

TEST_CASE("documentation: the version names licence, compiler, and of the libraries licences and sources") {
  const Called version = called({"--version"});
  CHECK(version.code == nothing_found);
  CHECK_THAT(version.out, StartsWith("touchstone 0.") && ContainsSubstring("\ncompiler: ") &&
                              ContainsSubstring("\nlicence: Apache-2.0\n"));
  for (const char* library : {"GMP", "MPFR", "nlohmann-json", "{fmt}", "CLI11", "libpng", "zlib", "Expat"}) {
    INFO(library);
    const std::size_t at = version.out.find(std::string("\n  ") + library + " ");
    REQUIRE(at != std::string::npos);
    CHECK(version.out.find("http", at) < version.out.find('\n', at + 1));
  }
}

TEST_CASE("documentation: no colours, on a terminal or not") {
  // NO_COLOR has nothing to switch off.
  for (const Called& call : {called({"--help"}), called({"audit", "--ops", "orientation", "--cases", "50"})}) {
    CHECK(call.out.find('\x1b') == std::string::npos);
    CHECK(call.err.find('\x1b') == std::string::npos);
  }
}

}  // namespace touchstone::proptests::documentation_tests
