// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/segment_segment.h"

#include "robust/batch/isa/rows.h"
#include "robust/lines/segment_segment.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::segment_segment_relation(q...); };

}  // namespace

void segment_segment(const Segments2& a, const Segments2& b, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, a, b);
}

}  // namespace touchstone::robust::batch
