// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/aabb_aabb.h"

#include "robust/batch/isa/rows.h"
#include "robust/volumes/aabb_aabb.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::aabb_aabb(q...); };

}  // namespace

void aabb_aabb(const Boxes2& a, const Boxes2& b, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, a, b);
}

void aabb_aabb(const Boxes3& a, const Boxes3& b, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, a, b);
}

}  // namespace touchstone::robust::batch
