// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "audit/shell_quoted.h"
#include "catalogue/codec/json.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// What is typed on the command line, and what the program says to type.
namespace touchstone::proptests::options_tests {
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

/// The words and the input of a line that calls touchstone, as a shell reads it.
struct Pasted {
  std::vector<std::string> words;
  std::string input;
};
Pasted pasted(const std::string& line) {
  const std::string said = said_by_shell("touchstone() { printf '%s\\036' \"$@\"; printf '\\035'; cat; }\n" + line);
  Pasted result;
  std::size_t begin = 0;
  for (std::size_t end; (end = said.find('\036', begin)) != std::string::npos; begin = end + 1)
    result.words.push_back(said.substr(begin, end - begin));
  result.input = said.substr(said.find('\035') + 1);
  return result;
}

}  // namespace

TEST_CASE("options: a word quoted for a shell is that word") {
  for (const std::string word :
       {"plain", "", "two words", "it's", "'", "$HOME `id` \"x\" \\ !", "a\nb %d '\\n", "~/x", "*"}) {
    INFO(word);
    CHECK(said_by_shell("printf '%s' " + shell_quoted(word)) == word);
  }
  CHECK(shell_quoted("a\nb\tc").find_first_of("\n\t") == std::string::npos);
  CHECK(shell_quoted("build/release/engines/geos") == "build/release/engines/geos");
}

TEST_CASE("options: the line that repeats a finding of an engine repeats it when it is pasted") {
  // Quotes of both kinds and a variable, as commands of engines have them.
  const std::string engine = "env MODE='a b' sh -c \"exec python3 examples/engine.py\"";
  const Called audit = called({"audit", "--ops", "orientation,segment_segment", "--cases", "400", "--seed", "1",
                               "--jobs", "1", "--timeout", "60", "--engine", engine.c_str()});
  CHECK(audit.code == findings);
  int repeated = 0;
  std::istringstream lines(audit.out);
  for (std::string line, verdict; std::getline(lines, line);) {
    for (const char* name : {"rounding", "algorithm"}) {
      if (line.find(std::string(", ") + name + ": ") != std::string::npos) verdict = name;
    }
    const std::string key = "  repeat    ";
    if (line.compare(0, key.size(), key) != 0) continue;
    const Pasted command = pasted(line.substr(key.size()));
    const TextFile input("repeat.jsonl", command.input);
    REQUIRE(command.words.size() >= 4);
    CHECK(std::find(command.words.begin(), command.words.end(), engine) != command.words.end());
    std::vector<const char*> words;
    for (const std::string& word : command.words) words.push_back(word.c_str());
    words.push_back(input.path());
    const Called ask = called(words);
    INFO(line << "\n" << ask.out << ask.err);
    CHECK(ask.code == findings);
    CHECK(ask.out.find(R"("verdict":"wrong","cause":")" + verdict, ask.out.find(R"("engine":)")) != std::string::npos);
    ++repeated;
  }
  CHECK(repeated >= 3);
}

TEST_CASE("options: the line that repeats a finding of the textbook formulas asks no engine") {
  const Called audit = called({"audit", "--ops", "orientation", "--cases", "400", "--jobs", "1"});
  const std::size_t repeat = audit.out.find("  repeat    ");
  REQUIRE(repeat != std::string::npos);
  const Pasted command = pasted(audit.out.substr(repeat + 12, audit.out.find('\n', repeat) - repeat - 12));
  CHECK(command.words == std::vector<std::string>{"ask", "orientation", "-"});
}

TEST_CASE("options: an empty command of an engine is refused, and audits nothing else") {
  const std::string rule = "expected the command of an engine, got an empty one";
  for (const char* empty : {"", " ", "\t\n"}) {
    require_refused(called({"audit", "--cases", "10", "--engine", empty}), bad_usage, rule);
    require_refused(called({"ask", "orientation", "--engine", empty}), bad_usage, rule);
  }
  require_refused(called({"audit", "--engine="}), bad_usage, "--engine: expected a value behind =, got nothing");
}

TEST_CASE("options: --json - is standard output, and the table goes to standard error") {
  const Called audit = called({"audit", "--ops", "orientation", "--cases", "100", "--jobs", "1", "--json", "-"});
  const TextFile file("tally.json", "");
  const Called written =
      called({"audit", "--ops", "orientation", "--cases", "100", "--jobs", "1", "--json", file.path()});
  std::stringstream text;
  text << std::ifstream(file.path()).rdbuf();
  CHECK(audit.out == text.str());
  CHECK(parse_own_line(audit.out)["kind"] == "tally");
  CHECK_THAT(audit.err, ContainsSubstring(written.out));
  CHECK(audit.code == written.code);
  CHECK_FALSE(std::filesystem::exists("-"));
  for (const std::vector<const char*>& decisions : {std::vector<const char*>{}, {"--decisions"}}) {
    std::vector<const char*> arguments{"exhaust", "orientation", "--grid", "2", "--json", "-"};
    arguments.insert(arguments.end(), decisions.begin(), decisions.end());
    const Called exhaust = called(arguments);
    CHECK(std::count(exhaust.out.begin(), exhaust.out.end(), '\n') == 1);
    CHECK(parse_own_line(exhaust.out).is_object());
  }
}

TEST_CASE("options: a folder where a file is asked for is told as a folder") {
  const std::string is_folder = ": cannot be read: is a directory\n";
  for (const char* option : {"--baseline", "--before"}) {
    const TextFile report("report", "");
    std::filesystem::remove(report.path());
    const Called call = called({"audit", "--cases", "1", "--report", report.path(), option, "proptests"});
    INFO(option);
    CHECK(call.err == "touchstone: " + std::string(option) + " proptests" + is_folder);
    CHECK(call.code == bad_usage);
  }
  CHECK(called({"ask", "orientation", "proptests"}).err == "touchstone: proptests" + is_folder);
  CHECK(called({"certify", "proptests"}).err == "touchstone: proptests" + is_folder);
  CHECK(called({"merge", "proptests"}).err == "touchstone: proptests" + is_folder);
}

TEST_CASE("options: ops with words lists the operations nearest to them, each with its question") {
  const Called rays = called({"ops", "ray", "mesh"});
  CHECK(rays.code == nothing_found);
  CHECK_THAT(rays.out, StartsWith("ray_triangle  ") && ContainsSubstring("?\n"));
  CHECK(std::count(rays.out.begin(), rays.out.end(), '\n') <= 8);
  CHECK_THAT(called({"ops", "signed distance"}).out,
             StartsWith("no operation computes a signed distance but from a plane; the nearest:\npoint_plane "));
  require_refused(called({"ops", "juggle"}), bad_usage, "ops juggle: no operation fits; `touchstone ops` lists all");
  require_refused(called({"ops", "ray", "--json"}), bad_usage, "--json");
}

TEST_CASE("options: certify says once that a file holds no claims") {
  const TextFile mesh("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  require_refused(called({"certify", mesh.path()}), bad_usage, "line 1: not JSON; certify reads lines as ask and");
}

TEST_CASE("options: a name misspelt is told with the one that was probably meant") {
  require_refused(called({"ask", "orientaton"}), bad_usage,
                  "operation orientaton: no operation of the catalogue (did you mean \"orientation\"?)");
  require_refused(called({"ask", "juggle"}), bad_usage,
                  "operation juggle: no operation of the catalogue; `touchstone ops` lists all");
  require_refused(
      called({"ask", "penetration_depth"}), bad_usage,
      "operation penetration_depth: no operation of the catalogue; no operation computes a penetration depth or "
      "a least translation that separates; nearest by words: convex_distance, polyhedron_polyhedron, "
      "penalty_force; `touchstone ops` lists all");
  require_refused(called({"audit", "--ops", "orientation,line_lin"}), bad_usage, "(did you mean \"line_line\"?)");
  require_refused(called({"audit", "--sed", "1"}), bad_usage,
                  "--sed: no option of touchstone audit (did you mean \"--seed\"?)");
  require_refused(called({"vectors", "chek", "vectors"}), bad_usage, "chek: no command (did you mean \"check\"?)");
  require_refused(called({"audit", "--families", "colinear", "--ops", "orientation"}), bad_usage,
                  "--families colinear: no family of these operations (did you mean \"collinear");
}

TEST_CASE("options: a value that looks like an option is a value") {
  // The engine does not start: what stands behind --engine was taken for its command.
  require_refused(called({"ask", "orientation", "--engine", "--sed"}), engine_failed, "engine --sed: ");
}

TEST_CASE("options: defaults stand in the help") {
  const Called help = called({"audit", "--help"});
  CHECK(help.code == nothing_found);
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--cases", "20000"},
                                                                                      {"--seed", "1"},
                                                                                      {"--timeout", "5"},
                                                                                      {"--ops", "all"},
                                                                                      {"--jobs", "one a processor"},
                                                                                      {"--seconds", "none"}}) {
    INFO(help.out);
    const std::size_t line = help.out.find("\n  " + option + " ");
    REQUIRE(line != std::string::npos);
    // As CLI11 writes it before and after 2.5.
    CHECK_THAT(help.out.substr(line + 1, help.out.find('\n', line + 1) - line),
               ContainsSubstring("=" + value) || ContainsSubstring("[" + value + "]"));
  }
  CHECK_THAT(help.out, ContainsSubstring("nested at most 64 deep") && ContainsSubstring("Exit codes: 0 nothing found"));
}

}  // namespace touchstone::proptests::options_tests
