// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/sphere_obb.h"

#include "robust/batch/isa/run.h"
#include "robust/volumes/sphere_obb.h"

namespace touchstone::robust::batch {

void sphere_obb(const Spheres3& spheres, const Obbs3& boxes, std::size_t count, std::uint8_t* answers,
                const Limits& limits) {
  constexpr auto decide = [](const auto&... q) { return robust::sphere_obb(q...); };
  isa::run(isa::Which{&isa::Filters::sphere_obb}, limits, decide, decide, count, answers, spheres, boxes);
}

}  // namespace touchstone::robust::batch
