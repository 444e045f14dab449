// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_triangles.h"
#include "geometry/capsules.h"

namespace touchstone::catalogue {

template <class R>
struct Described<Capsule3<R>> {
  static constexpr Form form = Form::record;
  static constexpr Meaning meaning = Meaning::length;  // of the radius
  static constexpr auto members =
      std::tuple{member("segment", &Capsule3<R>::segment), member("radius", &Capsule3<R>::radius)};
};

}  // namespace touchstone::catalogue
