// SPDX-License-Identifier: Apache-2.0
#include "audit/parallel.h"

#include <atomic>
#include <latch>
#include <stdexcept>
#include <vector>

#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/maps/map_image.h"

namespace touchstone::proptests::parallel_tests {

TEST_CASE("parallel: every number is worked on once, however many jobs there are") {
  for (const int jobs : {-1, 0, 1, 3, 200}) {
    std::vector<std::atomic<int>> calls(100);
    in_parallel(jobs, calls.size(), [&](std::size_t i) { ++calls[i]; });
    for (const auto& n : calls) CHECK(n == 1);
  }
  in_parallel(4, 0, [](std::size_t) { FAIL("nothing was to be done"); });
}

TEST_CASE("parallel: three jobs work at the same time") {
  std::latch all(3);
  in_parallel(3, 3, [&](std::size_t) { all.arrive_and_wait(); });
  CHECK(all.try_wait());
}

TEST_CASE("parallel: what a call throws reaches the caller; alone, nothing else is begun") {
  for (const int jobs : {1, 4}) {
    std::atomic<int> calls = 0;
    const auto work = [&](std::size_t i) {
      ++calls;
      if (i == 2) throw std::runtime_error("two");
    };
    CHECK_THROWS_WITH(in_parallel(jobs, 100, work), "two");
    if (jobs == 1) CHECK(calls == 3);
  }
}

TEST_CASE("parallel: a failure map is the same with any number of jobs") {
  const auto alone = failure_maps(*find_operation("orientation"), 1),
             together = failure_maps(*find_operation("orientation"), 5);
  REQUIRE(alone.size() == together.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    CHECK(alone[i].counts == together[i].counts);
    CHECK(alone[i].squares == together[i].squares);
    REQUIRE(alone[i].classes.size() == together[i].classes.size());
    for (std::size_t k = 0; k < alone[i].classes.size(); ++k) {
      CHECK(alone[i].classes[k].said == together[i].classes[k].said);
      CHECK(alone[i].classes[k].count == together[i].classes[k].count);
    }
  }
}

}  // namespace touchstone::proptests::parallel_tests
