// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "audit/logs/recorded_call.h"

namespace touchstone::audit {

/// The course of the textbook formula on a recorded call, in double or, where `binary32`, in float, under running error
/// analysis (catalogue/numbers/tracked.h).
struct Course {
  std::vector<Word> words;  ///< of its answer
  double nearest;           ///< Tracked::nearest_comparison
  bool in_doubt;            ///< rounding may have changed a comparison, or a number left the range
};
Course course_of(const RecordedCall& call, bool binary32);

}  // namespace touchstone::audit
