// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/judge/compare.h"
#include "catalogue/operation/examination.h"

/// The verdict on numbers that are further off than the stated bound (docs/judging.md, Numbers).
namespace touchstone::catalogue {

/// Numbers within this multiple of the textbook formula's bound by running error analysis are attributed to rounding.
inline constexpr int explained_spreads = 8;

struct JudgedNumber {
  Verdict verdict = Verdict::agree;
  double ulps = 0;  ///< its distance from the truth
  OffNumber number;
};

/// The right answer nearest to a complete answer that names other points than the truth does, equally near ones.
std::optional<EncodedTruth> other_as_near(const Examination& question, const EncodedValue<double>& answer);

/// Among the numbers of an answer beyond the stated bound, all of them finite, the one with the gravest verdict
/// (`inexact`, `rounding`, `algorithm`), and among these the one furthest off in ulps.
JudgedNumber worst_number(const Examination& question, const EncodedValue<double>& answer, Reading reading,
                          const Declaration& declaration);

/// True if the decision turns on less than a few units in the last place of the question's numbers: any formula that
/// rounds may take it for a touch.
bool near_touch(const Examination& question, bool binary32);

}  // namespace touchstone::catalogue
