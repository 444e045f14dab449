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

/// The judge's verdict on one answer; the columns of every table.
enum class Verdict {
  agree,        ///< right: the decision, and every number to within the stated bound
  rounding,     ///< wrong: the same formula in exact arithmetic is right (docs/judging.md)
  algorithm,    ///< wrong: the formula is wrong, or undefined, even in exact arithmetic
  inexact,      ///< right except for a number that is further off than the stated bound, as rounding explains
  convention,   ///< right for open sets, if the truth is a touch and the engine does not promise closed sets
  tolerance,    ///< wrong decision within the tolerance that the engine declared
  invalid,      ///< NaN, infinity for a finite truth, exception, crash, timeout, malformed answer
  unsupported,  ///< the engine does not answer this operation or this input
};

inline constexpr std::size_t verdict_count = 8;
inline constexpr std::array<const char*, verdict_count> verdict_names{
    "agree", "rounding", "algorithm", "inexact", "convention", "tolerance", "invalid", "unsupported"};
inline const char* name_of(Verdict v) { return verdict_names[static_cast<std::size_t>(v)]; }

/// A finding makes an audit exit with 1.
inline bool is_finding(Verdict v) {
  return v == Verdict::rounding || v == Verdict::algorithm || v == Verdict::inexact || v == Verdict::invalid;
}

/// A number of an answer that is off.
struct OffNumber {
  double exact = 0;  ///< the number of the engine's type nearest to the exact one
  double answered = 0;
};

struct Judgement {
  Verdict verdict = Verdict::agree;
  double ulps = 0;     ///< greatest distance of a number from the exact one, in units in the last place
  std::string remark;  ///< for `invalid`, and for an answer that a checker refuses: its defect
  int touch_reading =
      0;              ///< if the truth is a touch: +1 answered as closed sets, -1 as open sets, 0 neither or no touch
  bool clear = true;  ///< for a touch: no formula that the judge knows rounds there
  std::uint64_t surplus = 0;  ///< for an answer that must cover: the number of elements beyond the truth
  std::uint64_t apart = 0;    ///< for the same: the number of possible elements beyond the truth
  /// The answer's enumerators ("boundary"), "value" if it has none, "true" or "false" if it was a plain one; empty if
  /// there is no valid answer.
  std::string said = {};
  /// For `rounding`: a number left the range of the number type during the computation; otherwise sums cancelled.
  bool out_of_range = false;
  bool degenerate = false;  ///< the margin is 0
  /// The worst number, if the verdict is about numbers because all decisions are right.
  std::optional<OffNumber> number = {};
  bool breaks_tie = false;  ///< it names other points than the truth does, and they are equally near
};

/// A foreign engine's declaration of how it is to be judged.
struct Declaration {
  enum class Boundary { closed, open, unspecified };
  std::string engine;
  Boundary boundary = Boundary::unspecified;
  bool binary32 = false;  ///< number type; inputs are drawn so that they are exact in it
  double tolerance = 0;   ///< in the unit of the input coordinates
  /// The contents of lists of pairs: only those that meet, or also others, as in a broad phase.
  enum class Pairs { conservative, exact };
  Pairs pairs = Pairs::conservative;
  /// If several pairs of points are equally near: whether it names the contract's pair, or any of them.
  enum class Nearest { any, named };
  Nearest nearest = Nearest::any;
  bool skew_boxes = false;  ///< accepts oriented boxes whose axes are not perpendicular
  bool polygons = false;    ///< accepts faces of more than three corners
  /// For operations whose questions have alternatives (in the plane, in space): those that it answers, if it does not
  /// answer all, counted from 0.
  std::map<std::string, std::set<std::size_t>> alternatives = {};
};

}  // namespace touchstone::catalogue
