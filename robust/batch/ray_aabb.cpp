// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/ray_aabb.h"

#include "robust/batch/isa/run.h"
#include "robust/mixed/ray_aabb.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::ray_aabb_relation(q...); };
constexpr auto past_filter = [](const auto&... q) { return stages::ray_aabb::decision::past_filter(q...).answer; };

}  // namespace

void ray_aabb(const Rays2& rays, const Boxes2& boxes, std::size_t count, std::uint8_t* answers, const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::ray_and_box_in_plane, &isa::Filters::close_ray_and_box_in_plane}, limits, decide,
           past_filter, count, answers, rays, boxes);
}

void ray_aabb(const Rays3& rays, const Boxes3& boxes, std::size_t count, std::uint8_t* answers, const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::ray_and_box_in_space, &isa::Filters::close_ray_and_box_in_space}, limits, decide,
           past_filter, count, answers, rays, boxes);
}

}  // namespace touchstone::robust::batch
