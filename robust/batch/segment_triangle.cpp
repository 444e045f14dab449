// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/segment_triangle.h"

#include "robust/batch/isa/run.h"
#include "robust/polyhedra/segment_triangle.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::segment_triangle_relation(q...); };
constexpr auto past_filter = [](const auto&... q) {
  return stages::segment_triangle::decision::past_filter(q...).answer;
};

}  // namespace

void segment_triangle(const Segments3& segments, const Triangles3& triangles, std::size_t count, std::uint8_t* answers,
                      const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::segment_triangle, &isa::Filters::close_segment_triangle}, limits, decide,
           past_filter, count, answers, segments, triangles);
}

}  // namespace touchstone::robust::batch
