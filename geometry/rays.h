// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"

namespace touchstone {

/// The closed set origin + t direction, t >= 0, in space; t counts in lengths of the direction as given. A zero
/// direction is refused.
template <class Real>
struct Ray3 {
  Point3<Real> origin;
  Vector3<Real> direction;
};

using Ray3d = Ray3<double>;

}  // namespace touchstone
