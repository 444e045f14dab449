// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/segment_segment.h"

#include "robust/batch/isa/run.h"
#include "robust/lines/segment_segment.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::segment_segment_relation(q...); };
constexpr auto past_filter = [](const auto&... q) {
  return stages::segment_segment::decision::past_filter(q...).answer;
};

}  // namespace

void segment_segment(const Segments2& a, const Segments2& b, std::size_t count, std::uint8_t* answers,
                     const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::segment_segment, &isa::Filters::close_segment_segment}, limits, decide,
           past_filter, count, answers, a, b);
}

}  // namespace touchstone::robust::batch
