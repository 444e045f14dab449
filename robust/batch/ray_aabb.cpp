// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/ray_aabb.h"

#include "robust/batch/isa/rows.h"
#include "robust/mixed/ray_aabb.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::ray_aabb_relation(q...); };

}  // namespace

void ray_aabb(const Rays2& rays, const Boxes2& boxes, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, rays, boxes);
}

void ray_aabb(const Rays3& rays, const Boxes3& boxes, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, rays, boxes);
}

}  // namespace touchstone::robust::batch
