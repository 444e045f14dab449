// SPDX-License-Identifier: Apache-2.0
#include "audit/judging/course.h"

#include <limits>
#include <utility>

namespace touchstone::audit {

Course course_of(const RecordedCall& call, bool binary32) {
  Tracked::inconclusive() = Tracked::out_of_range() = false;
  Tracked::nearest_comparison() = std::numeric_limits<double>::infinity();
  EncodedValue<Tracked> answer = call.operation->row().reference_tracked.ask(call.question, binary32);
  return {std::move(answer.words), Tracked::nearest_comparison(), Tracked::inconclusive() || Tracked::out_of_range()};
}

}  // namespace touchstone::audit
