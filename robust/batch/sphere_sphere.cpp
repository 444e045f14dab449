// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/sphere_sphere.h"

#include "robust/batch/isa/run.h"
#include "robust/volumes/sphere_sphere.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::sphere_sphere(q...); };
constexpr auto past_filter = [](const auto&... q) { return stages::sphere_sphere::past_filter(q...).answer; };

}  // namespace

void sphere_sphere(const Spheres2& a, const Spheres2& b, std::size_t count, std::uint8_t* answers,
                   const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::spheres_in_plane, &isa::Filters::close_spheres_in_plane}, limits, decide,
           past_filter, count, answers, a, b);
}

void sphere_sphere(const Spheres3& a, const Spheres3& b, std::size_t count, std::uint8_t* answers,
                   const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::spheres_in_space, &isa::Filters::close_spheres_in_space}, limits, decide,
           past_filter, count, answers, a, b);
}

}  // namespace touchstone::robust::batch
