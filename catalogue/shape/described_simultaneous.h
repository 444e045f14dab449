// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_bodies.h"
#include "geometry/simultaneous.h"

namespace touchstone::catalogue {

template <class R>
struct Described<SimultaneousVelocities<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("relation", &SimultaneousVelocities<R>::relation),
                                             member("velocities", &SimultaneousVelocities<R>::velocities)};
};
template <>
struct Words<Resolution> {
  static constexpr std::array<const char*, 2> words{"possible", "impossible"};
};

}  // namespace touchstone::catalogue
