// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_plane.h"

#include "robust/batch/isa/run.h"
#include "robust/planes/point_plane.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::point_plane_side(q...); };
constexpr auto past_filter = [](const auto&... q) { return stages::point_plane::decision::past_filter(q...).answer; };

}  // namespace

void point_plane(const Planes& planes, const Points3& points, std::size_t count, std::uint8_t* answers,
                 const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::point_plane, &isa::Filters::close_point_plane}, limits, decide, past_filter, count,
           answers, planes, points);
}

}  // namespace touchstone::robust::batch
