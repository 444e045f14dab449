// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/triangle_triangle.h"

#include "robust/batch/isa/run.h"
#include "robust/polyhedra/triangle_triangle.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::triangle_triangle(q...); };
constexpr auto past_filter = [](const auto&... q) { return stages::triangle_triangle::past_filter(q...).answer; };

}  // namespace

void triangle_triangle(const Triangles3& a, const Triangles3& b, std::size_t count, std::uint8_t* answers,
                       const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::triangle_triangle, &isa::Filters::close_triangle_triangle}, limits, decide,
           past_filter, count, answers, a, b);
}

}  // namespace touchstone::robust::batch
