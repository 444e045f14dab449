// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/triangle_triangle.h"

#include "robust/batch/isa/rows.h"
#include "robust/polyhedra/triangle_triangle.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::triangle_triangle(q...); };

}  // namespace

void triangle_triangle(const Triangles3& a, const Triangles3& b, std::size_t count, std::uint8_t* answers,
                       Instructions) {
  decide_each(decide, count, answers, a, b);
}

}  // namespace touchstone::robust::batch
