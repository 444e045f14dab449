// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/ray_triangle.h"

#include "robust/batch/isa/run.h"
#include "robust/mixed/ray_triangle.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::ray_triangle_relation(q...); };
constexpr auto past_filter = [](const auto&... q) { return stages::ray_triangle::decision::past_filter(q...).answer; };

}  // namespace

void ray_triangle(const Rays3& rays, const Triangles3& triangles, std::size_t count, std::uint8_t* answers,
                  const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::ray_triangle, &isa::Filters::close_ray_triangle}, limits, decide, past_filter,
           count, answers, rays, triangles);
}

}  // namespace touchstone::robust::batch
