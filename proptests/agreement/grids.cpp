// SPDX-License-Identifier: Apache-2.0
#include <numeric>

#include "catalogue/operation/judgement.h"
#include "catalogue/operation/probes/explained.h"
#include "proptests/any_robust_bits.h"
#include "proptests/each_operation.h"
#include "proptests/property.h"

namespace touchstone::proptests::grids_tests {
namespace {

using catalogue::Operation;
using catalogue::Question;
using catalogue::Verdict;

/// The decision by the oracle's second method, where it has one.
std::string second_truth(const Operation& operation, const Question& question) {
  if (operation.row().decide_by_integers == nullptr) return "";
  return operation.row().decision->words[operation.row().decide_by_integers(question)];
}

/// What is asked of a grid: configurations of the numbers first, first + 1, ..., `size` of them; of more than `most`
/// (times TOUCHSTONE_CASES) that many (`touchstone exhaust` asks the rest); each `every`-th certificate
/// is checked too.
struct Grid {
  int size;
  double first;
  int most;
  std::uint64_t every;
};

/// From one configuration to the next, of so many: to the neighbour where all are asked, else by the golden section of
/// all, so that every number of the question takes every value.
std::uint64_t stride(std::uint64_t all, std::uint64_t asked, int size) {
  if (asked >= all) return 1;
  std::uint64_t step = static_cast<std::uint64_t>(0.6180339887498949 * static_cast<double>(all)) + 1;
  while (std::gcd(step, static_cast<std::uint64_t>(size)) != 1) ++step;
  return step;
}

/// Robust, the oracle and the oracle's second method agree.
void exhaust(const Operation& operation, const Grid& grid, std::size_t list_length) {
  const std::uint64_t all = operation.configurations(grid.size, list_length).value();
  const auto most = static_cast<std::uint64_t>(scaled(grid.most / operation.metadata().cost));
  const std::uint64_t asked = std::min(all, most), step = stride(all, asked, grid.size);
  std::uint64_t index = 0, valid = 0;
  for (std::uint64_t number = 0; number < asked; ++number, index += index < all - step ? step : step - all) {
    Question question = operation.on_grid(grid.size, index, list_length);
    for (double& number : question.numbers) number += grid.first;
    const auto shown = [&] { return catalogue::one_line(operation.print(question)); };
    try {
      const auto examination = operation.examine(question);
      ++valid;
      if (examination->judge_robust().verdict != Verdict::agree) FAIL_CHECK("robust: " << shown());
      const std::string second = second_truth(operation, question);
      if (!second.empty() && second != examination->outcome())
        FAIL_CHECK("the oracle's two methods differ: " << shown());
      const std::string broken = catalogue::broken_promise(*examination);
      if (!broken.empty()) FAIL_CHECK(broken << ": " << shown());
      if (number % grid.every != 0) continue;
      const std::string refused = catalogue::certificate_complaint(*examination);
      if (!refused.empty()) FAIL_CHECK(refused << ": " << shown());
    } catch (const InvalidInput&) {
      const std::string mismatch = operation.refusal_mismatch(question);
      if (!mismatch.empty()) FAIL_CHECK(mismatch << ": " << shown());
    }
  }
  CHECK(valid > 0);
}

}  // namespace

// Without lists no operation has more than 8 numbers: 4^8 = 65536 configurations.
EACH_OPERATION("every configuration of the numbers -1, 0, 1") {
  exhaust(operation, {.size = 3, .first = -1, .most = 1 << 16, .every = 16}, operation.metadata().list_length);
}
EACH_OPERATION("every configuration of the numbers 0, 1, 2, 3") {
  if (operation.metadata().is_implementation()) return;  // the questions are the operation's: one grid is enough
  exhaust(operation, {.size = 4, .first = 0, .most = 1 << 16, .every = 64}, operation.metadata().list_length);
}
EACH_OPERATION("configurations of the numbers -1, 0, 1 with one vertex more") {
  if (operation.metadata().is_implementation()) return;
  if (const std::size_t usual = operation.metadata().list_length) {
    exhaust(operation, {.size = 3, .first = -1, .most = 1 << 15, .every = 64}, usual + 1);
  }
}

EACH_OPERATION("decisions counted at full speed are those of the full examination") {
  const int size = *operation.configurations(3) < 100'000 ? 3 : 2;
  const auto whole = operation.count_decisions(size, 0, *operation.configurations(size));
  if (!whole) return;
  CHECK(whole->wrong == 0);
  std::map<std::string, std::uint64_t> outcomes;
  for (std::uint64_t index = 0; index < whole->cases; ++index)
    ++outcomes[operation.examine(operation.on_grid(size, index))->outcome()];
  for (const auto& [outcome, count] : whole->outcomes) CHECK(outcomes[outcome] == count);
  const std::uint64_t third = whole->cases / 3;
  std::uint64_t hash = 0;
  for (const auto& [first, last] :
       {std::pair{std::uint64_t{0}, third}, {third, 2 * third}, {2 * third, whole->cases}}) {
    hash += operation.count_decisions(size, first, last)->hash;
  }
  CHECK(hash == whole->hash);
  std::uint64_t of_grid = 0;
  for (const auto& [outcome, count] : whole->of_grid) of_grid += count;
  if (of_grid > 0) CHECK(of_grid == operation.configurations_of_plain_grid(size, operation.metadata().list_length));
}

}  // namespace touchstone::proptests::grids_tests
