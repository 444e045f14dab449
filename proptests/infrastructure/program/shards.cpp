// SPDX-License-Identifier: Apache-2.0
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <map>
#include <thread>

#include "catalogue/codec/json.h"
#include "program/runs/rounds.h"
#include "program/runs/shard.h"
#include "program/terminal/exit_codes.h"
#include "proptests/infrastructure/program/called.h"

/// Runs in parts: which part a process has, what is kept when it is stopped, and what merges.
namespace touchstone::proptests::shards_tests {
namespace {

namespace fs = std::filesystem;
using Variables = std::map<std::string, std::string>;

Shard shard_under(const Variables& variables, const std::string& option = "") {
  return shard_of(option, [&](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder of this process that is gone afterwards.
class Folder {
 public:
  Folder() { fs::create_directories(path_); }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_ = fs::temp_directory_path() / (std::to_string(::getpid()) + "_parts");
};

Called called_with(const std::vector<std::string>& words) {
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return called(arguments);
}

/// The program in a process of its own, which is killed as soon as its state has been kept.
void killed_once_kept(const std::vector<std::string>& words, const std::string& part) {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    called_with(words);
    _exit(0);
  }
  for (int i = 0; i < 6000 && !fs::exists(part); ++i) {
    INFO("it ended before anything was kept");
    REQUIRE(waitpid(child, nullptr, WNOHANG) == 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  REQUIRE(kill(child, SIGKILL) == 0);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
}

}  // namespace

TEST_CASE("shards: each launcher's variables name the part") {
  struct Case {
    Variables variables;
    std::uint64_t index, of;
  };
  const Variables slurm{{"SLURM_ARRAY_TASK_ID", "7"},
                        {"SLURM_ARRAY_TASK_MIN", "5"},
                        {"SLURM_ARRAY_TASK_MAX", "9"},
                        {"SLURM_ARRAY_TASK_COUNT", "5"}};
  Variables some_of_slurm = slurm;
  some_of_slurm["TOUCHSTONE_SHARDS"] = "12";
  for (const Case& its : {Case{slurm, 3, 5}, Case{some_of_slurm, 7, 12},
                          Case{{{"JOB_COMPLETION_INDEX", "0"}, {"TOUCHSTONE_SHARDS", "4"}}, 1, 4},
                          Case{{{"JOB_COMPLETION_INDEX", "3"}, {"TOUCHSTONE_SHARDS", "4"}}, 4, 4},
                          Case{{{"PARALLEL_SEQ", "4"}, {"TOUCHSTONE_SHARDS", "4"}}, 4, 4},
                          Case{{{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "2"}}, 1, 2},
                          Case{{{"PMI_RANK", "1"}, {"PMI_SIZE", "2"}}, 2, 2}}) {
    INFO(its.variables.begin()->first);
    CHECK(shard_under(its.variables).named());
    CHECK(shard_under(its.variables).index == its.index);
    CHECK(shard_under(its.variables).of == its.of);
    CHECK(shard_under(its.variables, "2/3").of == 3);  // what is typed counts
  }
  CHECK(in_words(shard_under(slurm)) == "shard 3/5 (Slurm array)");
}

TEST_CASE("shards: a launcher that does not say how many there are, or of one process, cuts nothing") {
  CHECK(!shard_under({}).named());
  CHECK(!shard_under({{"PARALLEL_SEQ", "3"}}).named());
  CHECK(!shard_under({{"JOB_COMPLETION_INDEX", "3"}}).named());
  CHECK(!shard_under({{"SLURM_ARRAY_TASK_ID", ""}, {"TOUCHSTONE_SHARDS", "8"}}).named());
  // A process manager of one process in a task of an array.
  const Shard shard = shard_under({{"SLURM_ARRAY_TASK_ID", "2"},
                                   {"SLURM_ARRAY_TASK_MIN", "1"},
                                   {"SLURM_ARRAY_TASK_MAX", "3"},
                                   {"PMI_RANK", "0"},
                                   {"PMI_SIZE", "1"}});
  CHECK(in_words(shard) == "shard 2/3 (Slurm array)");
}

TEST_CASE("shards: variables that name no part are refused") {
  const std::vector<std::pair<Variables, std::string>> refused{
      {{{"SLURM_ARRAY_TASK_ID", "x"}}, "SLURM_ARRAY_TASK_ID: expected an integer, got x"},
      {{{"SLURM_ARRAY_TASK_ID", "1"}}, "SLURM_ARRAY_TASK_MAX: expected"},
      {{{"SLURM_ARRAY_TASK_ID", "9"},
        {"SLURM_ARRAY_TASK_MIN", "3"},
        {"SLURM_ARRAY_TASK_MAX", "9"},
        {"SLURM_ARRAY_TASK_COUNT", "3"}},
       "every task from 3 to 9, got 3 of them"},
      {{{"SLURM_ARRAY_TASK_ID", "0"}, {"TOUCHSTONE_SHARDS", "3"}}, "an index from 1"},
      {{{"PARALLEL_SEQ", "4"}, {"TOUCHSTONE_SHARDS", "3"}}, "GNU parallel: expected an index"},
      {{{"JOB_COMPLETION_INDEX", "3"}, {"TOUCHSTONE_SHARDS", "3"}}, "an index from 0"},
      {{{"PMI_RANK", "-1"}, {"PMI_SIZE", "2"}}, "PMI_RANK: expected an integer"},
      {{{"PMI_RANK", "1"}, {"PMI_SIZE", "2"}, {"PARALLEL_SEQ", "1"}, {"TOUCHSTONE_SHARDS", "3"}},
       "expected one launcher"},
  };
  for (const auto& [variables, words] : refused) {
    INFO(words);
    CHECK_THROWS_WITH(shard_under(variables), ContainsSubstring(words));
  }
}

TEST_CASE("shards: together they hold every index once") {
  for (const std::uint64_t total : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{10}, UINT64_MAX}) {
    for (const std::uint64_t of : {1, 2, 7, 100}) {
      std::uint64_t reached = 0;
      for (std::uint64_t i = 1; i <= of; ++i) {
        const Share share = share_of(total, {i, of});
        CHECK(share.first == reached);
        CHECK(share.size() - total / of <= 1);
        reached = share.last;
      }
      CHECK(reached == total);
    }
  }
}

TEST_CASE("shards: those that are missing are named, neighbours as a range") {
  CHECK(missing_shards(3, {1, 2, 3}).empty());
  CHECK(missing_shards(3, {1, 3}) == "1 of 3 shards are missing: 2");
  CHECK(missing_shards(9, {2, 6, 8}) == "6 of 9 shards are missing: 1, 3-5, 7, 9");
  CHECK(missing_shards(UINT64_MAX, {1}) ==
        "18446744073709551614 of 18446744073709551615 shards are missing: "
        "2-18446744073709551615");
}

TEST_CASE("shards: rounds give every index to one job, whatever their size") {
  std::vector<int> seen(100'000);
  Rounds rounds(3, 0.001);
  for (std::uint64_t next = 5; next < 99'999;) {
    const std::uint64_t before = next;
    next = rounds.run(next, 99'999, [&](std::size_t job, const Share& share) {
      CHECK(job < 3);
      for (std::uint64_t i = share.first; i < share.last; ++i) ++seen[i];
    });
    REQUIRE(next > before);
  }
  CHECK(std::count(seen.begin(), seen.end(), 1) == 99'994);
  CHECK(seen[4] + seen[99'999] == 0);
}

TEST_CASE(
    "shards: a run that was killed goes on where its state was kept, and its result is that of a run that was not") {
  const Folder folder;
  const std::string whole = folder / "whole", file = folder / "result", part = file + ".part";
  const std::vector<std::vector<std::string>> runs{
      {"exhaust", "segment_segment", "--grid", "11", "--decisions", "--jobs", "1"},
      {"exhaust", "ray_segment", "--grid", "6", "--jobs", "1"},
      {"soak", "orientation,ray_segment", "--cases", "600000", "--jobs", "2"},
      {"audit", "--ops", "orientation,ray_segment,line_line,segment_triangle", "--cases", "9000", "--jobs", "1"}};
  for (const auto& run : runs) {
    const auto with = [&](const std::string& json) {
      auto words = run;
      words.insert(words.end(), {"--shard", "2/3", "--json", json});
      return words;
    };
    INFO(run[0] + " " + run[1]);
    const int code = called_with(with(whole)).code;
    CHECK(!fs::exists(whole + ".part"));
    fs::remove(file);
    killed_once_kept(with(file), part);
    CHECK(!fs::exists(file));
    const Called again = called_with(with(file));
    CHECK(again.code == code);
    CHECK_THAT(again.err, ContainsSubstring("resumes from " + part));
    CHECK(text_of(file) == text_of(whole));
    CHECK(!fs::exists(part));
  }
  // Neither temporary files nor states are left.
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 2);
}

TEST_CASE("shards: the state of another run is refused, and one that is damaged") {
  const Folder folder;
  const std::string file = folder / "result";
  const auto go_on = [&](const std::string& part) {
    std::ofstream(file + ".part") << part;
    return called({"exhaust", "orientation", "--grid", "2", "--decisions", "--shard", "1/2", "--json", file.c_str()});
  };
  require_refused(go_on("{}"), bad_usage, "expected the state of a run that was stopped");
  require_refused(go_on("{\"run\":"), bad_usage, "expected the state of a run that was stopped");
  require_refused(go_on(R"({"run":"{\"exhaust\":\"orientation\",\"version\":\"0.0.9\"}","state":null})"), bad_usage,
                  "expected the state of this run");
  CHECK(!fs::exists(file));
}

TEST_CASE("shards: soaks and audits merge to those of one run; what is missing is named") {
  const Folder folder;
  const std::vector<std::vector<std::string>> runs{
      {"soak", "orientation,ray_segment", "--cases", "1000", "--seed", "3"},
      {"audit", "--ops", "line_line", "--cases", "1000", "--seed", "3"}};
  for (const auto& run : runs) {
    INFO(run[0]);
    const auto result = [&](const std::string& shard) {
      auto words = run;
      const std::string file = folder / (run[0] + "_" + shard.substr(0, 1) + shard.substr(2));
      words.insert(words.end(), {"--shard", shard, "--json", file});
      called_with(words);
      return file;
    };
    const std::string first = result("1/3"), second = result("2/3"), third = result("3/3"), whole = result("1/1");
    const std::string sum = folder / "sum";
    const Called merged = called({"merge", third.c_str(), first.c_str(), second.c_str(), "--json", sum.c_str()});
    CHECK(merged.code != bad_usage);
    const auto counted = [](const std::string& file) {  // all that the cut leaves as it is
      const catalogue::Json json = catalogue::parse_line(text_of(file));
      std::string text;
      for (const auto& operation : json["operations"]) {
        if (!operation.contains("families")) text += catalogue::one_line(operation);
        for (const auto& family : operation.value("families", catalogue::Json::array()))
          text += catalogue::one_line(family["counts"]) + catalogue::one_line(family["hash"]) +
                  catalogue::one_line(family["refused"]);
      }
      return text;
    };
    CHECK(!counted(whole).empty());
    CHECK(counted(sum) == counted(whole));

    const Called some = called({"merge", third.c_str(), first.c_str(), "--json", sum.c_str()});
    CHECK(some.code == bad_usage);
    CHECK_THAT(some.err, EndsWith("touchstone: merge: 1 of 3 shards are missing: 2\n"));
    CHECK(called({"merge", second.c_str(), sum.c_str()}).code == merged.code);  // the sum of some is one of them
    require_refused(called({"merge", first.c_str(), second.c_str(), first.c_str()}), bad_usage, "duplicate shard 1");
    require_refused(called({"merge", first.c_str(), sum.c_str()}), bad_usage, "duplicate shard 1");
    require_refused(called({"merge", first.c_str(), whole.c_str()}), bad_usage, "shards: the same in every file");

    const auto with = [&](const std::string& from, const std::string& to) {
      std::string text = text_of(second);
      REQUIRE(text.find(from) != std::string::npos);
      text.replace(text.find(from), from.size(), to);
      std::ofstream(folder / "tampered") << text;
      return folder / "tampered";
    };
    for (const auto& [from, to, words] :
         {std::tuple{"\"version\":\"0.1.0\"", "\"version\":\"0.2.0\"", "version: the same in every file"},
          {"\"seed\":3", "\"seed\":4", "seed: the same"},
          {"\"touchstone\":1", "\"touchstone\":2", "touchstone: version 1"},
          {"\"done\":[2]", "\"done\":[4]", "one of the shards"}}) {
      INFO(from);
      require_refused(called({"merge", first.c_str(), with(from, to).c_str()}), bad_usage, words);
    }
    if (run[0] == "soak") continue;
    require_refused(called({"merge", first.c_str(), (folder / "soak_13").c_str()}), bad_usage,
                    "kind: the same in every file");
  }
  // Ranges and sums of a soak.
  const std::string second = folder / "soak_23";
  for (const auto& [from, to, words] : {std::tuple{"[[333,666]]", "[[333,665]]", "as many as were counted"},
                                        {"[[333,666]]", "[[332,665]]", "all of shard 2"},
                                        {"[[333,666]]", "[[333,500],[499,665]]", "every case once"},
                                        {"\"wrong\":0", "\"wrong\":999", "no more than were counted"}}) {
    INFO(to);
    std::string text = text_of(second);
    REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), std::string(from).size(), to);
    std::ofstream(folder / "tampered") << text;
    require_refused(called({"merge", (folder / "tampered").c_str()}), bad_usage, words);
  }
}

TEST_CASE("soak: it ends when its time is over, having asked every operation") {
  const Folder folder;
  const std::string file = folder / "result";
  const Called soak =
      called({"soak", "orientation,line_line", "--seconds", "0.3", "--jobs", "1", "--json", file.c_str()});
  CHECK(soak.code == nothing_found);
  for (const char* operation : {"orientation", "line_line"}) {
    INFO(operation);
    CHECK_THAT(soak.out, ContainsSubstring(operation));
  }
  for (const auto& operation : catalogue::parse_line(text_of(file))["operations"]) CHECK(!operation["counted"].empty());
}

}  // namespace touchstone::proptests::shards_tests
