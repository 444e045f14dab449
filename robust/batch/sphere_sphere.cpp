// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/sphere_sphere.h"

#include "robust/batch/isa/rows.h"
#include "robust/volumes/sphere_sphere.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::sphere_sphere(q...); };

}  // namespace

void sphere_sphere(const Spheres2& a, const Spheres2& b, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, a, b);
}

void sphere_sphere(const Spheres3& a, const Spheres3& b, std::size_t count, std::uint8_t* answers, Instructions) {
  decide_each(decide, count, answers, a, b);
}

}  // namespace touchstone::robust::batch
