// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_sphere_triangle.h"

#include "geometry/validation.h"
#include "oracle/exact/moving/ball_near_polygon.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<FirstContact<Surd>> swept_sphere_triangle(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                                const Triangle3<Number>& triangle) {
  validation::validate_all("sphere", sphere, "velocity", velocity, "triangle", triangle);
  const auto& [a, b, c] = triangle;
  return first_contact({{exact(a), exact(b), exact(c)},
                        exact(sphere.center),
                        {exact(velocity.x), exact(velocity.y), exact(velocity.z)},
                        exact(sphere.radius)});
}
template Truth<FirstContact<Surd>> swept_sphere_triangle(const Sphere3d&, const Vector3d&, const Triangle3d&);
template Truth<FirstContact<Surd>> swept_sphere_triangle(const Sphere3<Rational>&, const Vector3<Rational>&,
                                                         const Triangle3<Rational>&);

}  // namespace touchstone::oracle
