// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/sphere_aabb.h"

#include "robust/batch/isa/run.h"
#include "robust/volumes/sphere_aabb.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::sphere_aabb(q...); };
constexpr auto past_filter = [](const auto&... q) { return stages::sphere_aabb::past_filter(q...).answer; };

}  // namespace

void sphere_aabb(const Spheres2& spheres, const Boxes2& boxes, std::size_t count, std::uint8_t* answers,
                 const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::sphere_and_box_in_plane, &isa::Filters::close_sphere_and_box_in_plane}, limits,
           decide, past_filter, count, answers, spheres, boxes);
}

void sphere_aabb(const Spheres3& spheres, const Boxes3& boxes, std::size_t count, std::uint8_t* answers,
                 const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::sphere_and_box_in_space, &isa::Filters::close_sphere_and_box_in_space}, limits,
           decide, past_filter, count, answers, spheres, boxes);
}

}  // namespace touchstone::robust::batch
