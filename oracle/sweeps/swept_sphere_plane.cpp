// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_sphere_plane.h"

#include "oracle/exact/shapes/half_space.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<FirstContact<Surd>> swept_sphere_plane(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                             const Plane<Number>& plane) {
  return sweep_to_plane("sphere", sphere, velocity, plane);
}
template Truth<FirstContact<Surd>> swept_sphere_plane(const Sphere3d&, const Vector3d&, const Plane3d&);
template Truth<FirstContact<Surd>> swept_sphere_plane(const Sphere3<Rational>&, const Vector3<Rational>&,
                                                      const Plane<Rational>&);

}  // namespace touchstone::oracle
