// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/ray_triangle.h"

#include "robust/batch/isa/rows.h"
#include "robust/mixed/ray_triangle.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::ray_triangle_relation(q...); };

}  // namespace

void ray_triangle(const Rays3& rays, const Triangles3& triangles, std::size_t count, std::uint8_t* answers,
                  Instructions) {
  decide_each(decide, count, answers, rays, triangles);
}

}  // namespace touchstone::robust::batch
