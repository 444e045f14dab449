// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/aabb_aabb.h"

#include "robust/batch/isa/run.h"
#include "robust/volumes/aabb_aabb.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::aabb_aabb(q...); };
constexpr auto past_filter = [](const auto&... q) { return stages::aabb_aabb::past_filter(q...).answer; };

}  // namespace

void aabb_aabb(const Boxes2& a, const Boxes2& b, std::size_t count, std::uint8_t* answers, const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::boxes_in_plane, &isa::Filters::close_boxes_in_plane}, limits, decide, past_filter,
           count, answers, a, b);
}

void aabb_aabb(const Boxes3& a, const Boxes3& b, std::size_t count, std::uint8_t* answers, const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::boxes_in_space, &isa::Filters::close_boxes_in_space}, limits, decide, past_filter,
           count, answers, a, b);
}

}  // namespace touchstone::robust::batch
