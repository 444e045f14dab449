// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/ray_obb.h"

#include "oracle/exact/shapes/obb_passage.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Passage<Rational>> ray_obb(const Ray3<Number>& ray, const Obb3<Number>& obb) {
  return passage_of_obb("ray", ray, obb);
}
template Truth<Passage<Rational>> ray_obb(const Ray3d&, const Obb3d&);
template Truth<Passage<Rational>> ray_obb(const Ray3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
