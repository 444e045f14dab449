// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/families/draw_stream.h"
#include "catalogue/families/numbers.h"
#include "catalogue/operation/row.h"
#include "catalogue/shape/encoded_value.h"
#include "catalogue/shape/walk.h"
#include "geometry/invalid_input.h"

/// The questions of the benchmarks. The same cases on every machine and with every compiler.
namespace touchstone::bench {

/// With fewer, the branch predictor learns the answers by heart: CGAL's orientation, measured over 512 cases in a loop,
/// seems five times faster than over this many.
inline constexpr std::size_t case_count = std::size_t{1} << 17;
/// For questions with lists, each of which has many branches of its own.
inline constexpr std::size_t case_count_of_lists = std::size_t{1} << 13;

enum class DataSet {
  random,              ///< every number uniform in [-1, 1)
  near_degenerate,     ///< random numbers rounded onto a degenerate place: hard cases of such a name (below)
  small_integer_grid,  ///< every number one of 0 .. 7: many cases are degenerate
  huge,                ///< random, lengths times 2^1012: every product of lengths overflows
  tiny,                ///< random, lengths so that all are multiples of 2^-1074: every product of lengths underflows
};

inline constexpr DataSet data_sets[] = {DataSet::random, DataSet::near_degenerate, DataSet::small_integer_grid,
                                        DataSet::huge, DataSet::tiny};

inline const char* name_of(DataSet set) {
  constexpr const char* names[] = {"random", "near_degenerate", "small_integer_grid", "scale_2^1012", "scale_2^-1074"};
  return names[static_cast<std::size_t>(set)];
}

/// Multiplies lengths by 2^k; anything else (a slope, an angle) stays.
template <class Row>
void scale(typename Row::Question& question, int k) {
  if (const auto own = Row::hooks().scale) {
    own(question, k);
  } else {
    catalogue::for_each_number(question, [&](double& number) { number = std::ldexp(number, k); });
  }
}

/// Returns whether the family's name says that it has full precision: random numbers rounded onto a degenerate place.
inline bool near_degenerate(std::string_view family) {
  return family.starts_with("nearly") || family.find("rounded") != std::string_view::npos;
}

/// The hard cases of full precision; all hard cases if none is named as one.
template <class Row>
std::vector<catalogue::HardCase<typename Row::Question>> near_misses() {
  const auto all = catalogue::hard_cases_of<Row>();
  auto chosen = all;
  std::erase_if(chosen, [](const auto& hard) { return !near_degenerate(hard.name); });
  return chosen.empty() ? all : chosen;
}

/// The elements of each list: as many as in exhaustive runs, or three where these have a world of their own.
template <class Row>
inline constexpr std::size_t list_length = Row::metadata.list_length != 0 ? Row::metadata.list_length : 3;

template <class Row>
bool has_lists() {
  bool found = false;
  typename Row::Question question{};
  catalogue::walk(question, [](double&) {}, [&found](auto&) { found = true; });
  return found;
}

template <class Row>
typename Row::Question drawn(DataSet set, catalogue::DrawStream& draws) {
  typename Row::Question question{};
  const auto fill = [&](double (*number)(catalogue::DrawStream&)) {
    catalogue::walk(
        question, [&](double& value) { value = number(draws); },
        [](auto& list) { list.resize(list_length<Row>); });
    if (const auto repair = Row::hooks().repair) repair(question);
  };
  switch (set) {
    case DataSet::near_degenerate: {
      static const auto hard = near_misses<Row>();
      return hard[draws.below(hard.size())].draw(draws);
    }
    case DataSet::small_integer_grid:
      fill([](catalogue::DrawStream& c) { return static_cast<double>(c.below(8)); });
      return question;
    case DataSet::random: fill(catalogue::ordinary); return question;
    case DataSet::huge: fill(catalogue::ordinary), scale<Row>(question, 1012); return question;
    case DataSet::tiny:
      fill(catalogue::ordinary), scale<Row>(question, 52), scale<Row>(question, -1074);
      return question;
  }
  return question;
}

/// Questions that the contract accepts. Ends with an error if it refuses nearly all draws.
template <class Row>
std::vector<typename Row::Question> draw_cases(DataSet set) {
  const std::string stream = std::string(Row::metadata.name) + "/" + name_of(set);
  std::vector<typename Row::Question> cases;
  const std::size_t count = has_lists<Row>() ? case_count_of_lists : case_count;
  cases.reserve(count);
  for (std::uint64_t index = 0; cases.size() < count; ++index) {
    if (index > 1000 * (cases.size() + 1000))
      throw std::runtime_error(stream + ": nearly all that is drawn is refused");
    catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, stream.c_str(), index));
    const auto question = drawn<Row>(set, draws);
    try {
      catalogue::ask_robust<Row>(question);
      cases.push_back(question);
    } catch (const InvalidInput&) {
    }
  }
  return cases;
}

/// The cases of one set, made on first use. Only the most recent set is kept.
template <class Row>
const std::vector<typename Row::Question>& cases_of(DataSet set) {
  static DataSet made = set;
  static std::vector<typename Row::Question> cases;
  if (cases.empty() || made != set) cases = draw_cases<Row>(made = set);
  return cases;
}

}  // namespace touchstone::bench
