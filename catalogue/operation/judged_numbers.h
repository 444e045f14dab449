// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/judge/compare.h"
#include "catalogue/operation/examination.h"

/// The verdict on numbers that are further off than the stated bound (docs/judging.md, Numbers).
namespace touchstone::catalogue {

/// So many times what running error analysis allows the textbook formula is laid to rounding.
inline constexpr int explained_spreads = 8;

struct JudgedNumber {
  Verdict verdict = Verdict::agree;
  double ulps = 0;  ///< how far off it is
  OffNumber number;
};

/// What a formula computed under running error analysis.
template <class Float>
EncodedValue<double> in_doubles(const EncodedValue<Tracked<Float>>& formula) {
  return encoded_with<double>(formula,
                              [](const Tracked<Float>& number) { return static_cast<double>(number.value()); });
}

/// The right answer that is nearest to a complete answer, where it names other points than the truth does, as near.
std::optional<EncodedTruth> other_as_near(const Examination& question, const EncodedValue<double>& answer);

/// Of the numbers of an answer beyond the stated bound, all of them finite, the one with the gravest verdict
/// (`inexact`, `rounding`, `algorithm`), and of these the one that is furthest off in ulps.
JudgedNumber worst_number(const Examination& question, const EncodedValue<double>& answer, Reading reading,
                          const Declaration& declaration);

/// The decision turns on less than a few units in the last place of the question's numbers: formulas that round at all
/// may take it for a touch.
bool beside_a_touch(const Examination& question, bool binary32);

}  // namespace touchstone::catalogue
