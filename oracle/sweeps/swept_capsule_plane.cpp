// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_capsule_plane.h"

#include "oracle/exact/shapes/half_space.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<FirstContact<Surd>> swept_capsule_plane(const Capsule3<Number>& capsule, const Vector3<Number>& velocity,
                                              const Plane<Number>& plane) {
  return sweep_to_plane("capsule", capsule, velocity, plane);
}
template Truth<FirstContact<Surd>> swept_capsule_plane(const Capsule3d&, const Vector3d&, const Plane3d&);
template Truth<FirstContact<Surd>> swept_capsule_plane(const Capsule3<Rational>&, const Vector3<Rational>&,
                                                       const Plane<Rational>&);

}  // namespace touchstone::oracle
