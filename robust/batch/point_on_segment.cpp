// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_on_segment.h"

#include "robust/batch/isa/run.h"
#include "robust/lines/point_on_segment.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::point_on_segment_relation(q...); };
constexpr auto past_filter = [](const auto&... q) {
  return stages::point_on_segment::decision::past_filter(q...).answer;
};

}  // namespace

void point_on_segment(const Points2& points, const Segments2& segments, std::size_t count, std::uint8_t* answers,
                      const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::point_on_segment, &isa::Filters::close_point_on_segment}, limits, decide,
           past_filter, count, answers, points, segments);
}

}  // namespace touchstone::robust::batch
