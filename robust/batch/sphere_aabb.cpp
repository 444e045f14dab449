// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/sphere_aabb.h"

#include "robust/batch/isa/rows.h"
#include "robust/volumes/sphere_aabb.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::sphere_aabb(q...); };

}  // namespace

void sphere_aabb(const Spheres2& spheres, const Boxes2& boxes, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, spheres, boxes);
}

void sphere_aabb(const Spheres3& spheres, const Boxes3& boxes, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, spheres, boxes);
}

}  // namespace touchstone::robust::batch
