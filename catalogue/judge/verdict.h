// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace touchstone::catalogue {

/// What the judge says of one answer; the columns of every table.
enum class Verdict {
  agree,        ///< right: what is decided, and every number to within the stated bound
  rounding,     ///< wrong: the same formula in exact arithmetic is right (docs/judging.md)
  algorithm,    ///< wrong: the formula is wrong, or undefined, even in exact arithmetic
  inexact,      ///< right but for a number that is further off than the stated bound, as rounding explains
  convention,   ///< right for open sets, where the truth is a touch and the engine does not promise closed sets
  tolerance,    ///< wrong decision within the tolerance that the engine declared
  invalid,      ///< NaN, infinity where the truth is finite, exception, crash, no answer in time, no valid answer
  unsupported,  ///< the engine does not answer this operation or this input
};

inline constexpr std::size_t verdict_count = 8;
inline constexpr std::array<const char*, verdict_count> verdict_names{
    "agree", "rounding", "algorithm", "inexact", "convention", "tolerance", "invalid", "unsupported"};
inline const char* name_of(Verdict v) { return verdict_names[static_cast<std::size_t>(v)]; }

/// A finding is what makes an audit exit with 1.
inline bool is_finding(Verdict v) {
  return v == Verdict::rounding || v == Verdict::algorithm || v == Verdict::inexact || v == Verdict::invalid;
}

/// A number of an answer that is off.
struct OffNumber {
  double exact = 0;  ///< the number of the engine's type that is nearest to the exact one
  double answered = 0;
};

struct Judgement {
  Verdict verdict = Verdict::agree;
  double ulps = 0;     ///< greatest distance of a number from the exact one, in units in the last place
  std::string remark;  ///< for `invalid`, and of an answer that a checker refuses: what is wrong with it
  int touch_reading =
      0;  ///< where the truth is a touch: +1 answered as closed sets, -1 as open sets, 0 neither or no touch
  bool clear = true;          ///< of a touch: no formula that the judge knows rounds there
  std::uint64_t surplus = 0;  ///< of an answer that must cover: what it holds beyond the truth
  std::uint64_t apart = 0;    ///< of the same: how much there is beyond the truth that it may hold
  /// The answer's enumerators ("boundary"), "value" where it has none, "true" or "false" where it was a plain one;
  /// empty where there is no valid answer.
  std::string said = {};
  /// Of `rounding`: a number left the range of the number type on the way; else sums cancelled.
  bool out_of_range = false;
  bool degenerate = false;  ///< the margin is 0
  /// Where the verdict is about a number, whatever is decided being right: the worst one.
  std::optional<OffNumber> number = {};
  bool breaks_tie = false;  ///< it names other points than the truth does, and they are as near
};

/// How a foreign engine wants to be judged.
struct Declaration {
  enum class Boundary { closed, open, unspecified };
  std::string engine;
  Boundary boundary = Boundary::unspecified;
  bool binary32 = false;  ///< number type; inputs are drawn so that they are exact in it
  double tolerance = 0;   ///< in the unit of the input coordinates
  /// What lists of pairs hold: those alone that meet, or these and others, as a broad phase does.
  enum class Pairs { conservative, exact };
  Pairs pairs = Pairs::conservative;
  /// Where several pairs of points are as near as any: whether it names the contract's, or one of them.
  enum class Nearest { any, named };
  Nearest nearest = Nearest::any;
  bool skew_boxes = false;  ///< takes oriented boxes that are not at right angles
  bool polygons = false;    ///< takes faces of more than three corners
  /// Of operations whose questions have alternatives (in the plane, in space): those that it answers, where it does not
  /// answer all, counted from 0.
  std::map<std::string, std::set<std::size_t>> alternatives = {};
};

}  // namespace touchstone::catalogue
