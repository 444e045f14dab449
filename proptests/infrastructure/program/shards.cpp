// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "program/runs/rounds.h"
#include "program/runs/shard.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

/// Which part of a run a process has.
namespace touchstone::proptests::shards_tests {
namespace {

using Variables = std::map<std::string, std::string>;

Shard shard_under(const Variables& variables, const std::string& option = "") {
  return shard_of(option, [&](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
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
      {{{"SLURM_ARRAY_TASK_ID", "1"}}, "SLURM_ARRAY_TASK_MAX: required with SLURM_ARRAY_TASK_ID"},
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

}  // namespace touchstone::proptests::shards_tests
