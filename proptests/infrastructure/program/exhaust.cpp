// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "geometry/invalid_input.h"
#include "program/commands/commands.h"
#include "program/program.h"
#include "program/runs/counted_run.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

/// Exhaustive runs cut into shards, and their merging.
namespace touchstone::proptests::exhaust_tests {
namespace {

/// Results of shards as files of this process that are gone afterwards.
class Shards {
 public:
  ~Shards() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  /// Runs `exhaust` on one shard and returns its file.
  std::string run(const std::string& operation, int grid, const std::string& shard, bool decisions,
                  std::size_t list_length = 0) {
    const std::string file = (folder_ / std::to_string(++runs_)).string();
    std::ostringstream out, err;
    exhaust_command({"touchstone", operation, grid, shard, file, decisions, "", usual_timeout, 0, list_length}, out,
                    err);
    return file;
  }
  std::vector<std::string> run_all(const std::string& operation, int grid, int shards, bool decisions) {
    std::vector<std::string> files;
    for (int i = 1; i <= shards; ++i)
      files.push_back(run(operation, grid, std::to_string(i) + "/" + std::to_string(shards), decisions));
    return files;
  }

 private:
  static std::filesystem::path made() {
    const auto folder = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_shards");
    std::filesystem::create_directories(folder);
    return folder;
  }
  std::filesystem::path folder_ = made();
  int runs_ = 0;
};

std::string merged(const std::vector<std::string>& files) {
  std::ostringstream out, err;
  try {
    merge_command({files, ""}, out, err);
    return out.str() + err.str();
  } catch (const UsageError& refused) {
    return refused.what();
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
}

std::string without_first_line(const std::string& text) { return text.substr(text.find('\n')); }

std::string only_line(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line + "\n";
}

}  // namespace

TEST_CASE("exhaust: the shards of every cut count every configuration once, in whatever order they are merged") {
  Shards shards;
  // The head line of a whole run does not speak of shards; ray_segment has refused configurations too.
  for (const auto& [operation, grid] : {std::pair{"orientation", 3}, {"ray_segment", 2}}) {
    const std::string whole = without_first_line(merged(shards.run_all(operation, grid, 1, false)));
    CHECK(whole.find(operation) != std::string::npos);
    for (const int cut : {2, 3, 7, 100}) {
      auto files = shards.run_all(operation, grid, cut, false);
      CHECK(without_first_line(merged(files)) == whole);
      std::reverse(files.begin(), files.end());
      CHECK(without_first_line(merged(files)) == whole);
    }
  }
}

TEST_CASE("exhaust: a shard that is missing is missed, one that is there twice or of another cut is refused") {
  Shards shards;
  const auto thirds = shards.run_all("orientation", 3, 3, false), halves = shards.run_all("orientation", 3, 2, false);
  CHECK_THAT(merged({thirds[0], thirds[2]}), ContainsSubstring("1 of 3 shards are missing"));
  CHECK_THAT(merged(thirds), !ContainsSubstring("missing"));
  CHECK_THAT(merged({thirds[0], thirds[1], thirds[0]}), EndsWith("line 1: grid.done: duplicate shard 1"));
  CHECK_THAT(merged({thirds[0], halves[1]}), EndsWith("line 1: grid.shards: the same in every file"));
  CHECK_THAT(merged({thirds[0], shards.run("orientation", 2, "2/3", false)}),
             EndsWith("line 1: grid.size: the same in every file"));
}

TEST_CASE("exhaust: decisions merge to those of one run; gaps, repetitions and other runs are refused") {
  Shards shards;
  for (const char* operation : {"orientation", "segment_segment"}) {
    const std::string whole = only_line(shards.run(operation, 3, "1/1", true));
    for (const int cut : {2, 3, 7}) {
      auto files = shards.run_all(operation, 3, cut, true);
      CHECK(merged(files) == whole);
      std::reverse(files.begin(), files.end());
      CHECK(merged(files) == whole);
    }
  }
  const auto thirds = shards.run_all("orientation", 3, 3, true);
  CHECK_THAT(merged({thirds[2], thirds[0]}),
             ContainsSubstring("\"counted\":[[0,243],[486,729]]") && EndsWith("1 of 3 shards are missing: 2\n"));
  CHECK_THAT(merged({thirds[0]}), EndsWith("2 of 3 shards are missing: 2-3\n"));
  CHECK_THAT(merged({thirds[0], thirds[1], thirds[1], thirds[2]}), EndsWith("done: duplicate shard 2"));
  CHECK_THAT(merged({thirds[0], shards.run("orientation", 3, "2/2", true)}),
             EndsWith("shards: the same in every file"));
  CHECK_THAT(merged({thirds[0], shards.run("orientation", 2, "2/3", true)}), EndsWith("grid: the same in every file"));
  CHECK_THAT(merged({thirds[0], shards.run("line_line", 3, "2/3", false)}), EndsWith("kind: the same in every file"));
}

TEST_CASE("exhaust: lists are as long as one likes, where there are lists") {
  Shards shards;
  // Three vertices and a point on the grid of 2 x 2: 2^8 configurations.
  const auto decided = read_counted_run(parse_line(only_line(shards.run("point_in_polygon", 2, "1/1", true, 3))));
  CHECK(decided.of == 256);
  CHECK(decided.wrong() == 0);
  const std::string examined = merged({shards.run("point_in_polygon", 2, "1/1", false, 3)});
  // Of these, 4 x 4 rings that return to their first vertex have two vertices, beside each of 4 points.
  CHECK_THAT(examined, ContainsSubstring("192") && ContainsSubstring("64 (at least 3 vertices: 64)"));
  CHECK_THAT(
      merged({shards.run("point_in_polygon", 2, "1/2", true, 3), shards.run("point_in_polygon", 2, "2/2", true, 4)}),
      EndsWith("of: the same in every file"));
  for (const char* without : {"orientation", "convex_hull"})  // no list, and a domain of its own
    CHECK_THROWS_AS(shards.run(without, 2, "1/1", false, 3), UsageError);
}

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

TEST_CASE("exhaust: a shard is I/N with 1 <= I <= N") {
  Shards shards;
  for (const char* shard : {"0/3", "4/3", "1/", "/3", "1", "a/b", "1/3x", "1:3", "1/0"}) {
    INFO(shard);
    CHECK_THROWS_AS(shards.run("orientation", 2, shard, false), UsageError);
  }
}

TEST_CASE("exhaust: what is no shard is refused") {
  for (const char* shard :
       {"1", "0/1", "2/1", "1/-1", "-1/2", "+1/2", "1/0", "1/2/3", "1 /2", "1/2 ", "a/b", "1/18446744073709551616"}) {
    std::ostringstream out, err;
    INFO(shard);
    CHECK_THROWS_AS(exhaust_command({"touchstone", "orientation", 2, shard, "", true}, out, err), UsageError);
  }
}

}  // namespace touchstone::proptests::exhaust_tests
