// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_plane.h"

#include "robust/batch/isa/rows.h"
#include "robust/planes/point_plane.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::point_plane_side(q...); };

}  // namespace

void point_plane(const Planes& planes, const Points3& points, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, planes, points);
}

}  // namespace touchstone::robust::batch
