// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/segment_triangle.h"

#include "robust/batch/isa/rows.h"
#include "robust/polyhedra/segment_triangle.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::segment_triangle_relation(q...); };

}  // namespace

void segment_triangle(const Segments3& segments, const Triangles3& triangles, std::size_t count, std::uint8_t* answers,
                      Instructions) {
  decide_each(decide, count, answers, segments, triangles);
}

}  // namespace touchstone::robust::batch
