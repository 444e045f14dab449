// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/ray_capsule.h"

#include "oracle/exact/shapes/passage.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Passage<Surd>> ray_capsule(const Ray3<Number>& ray, const Capsule3<Number>& capsule) {
  return passage_of_capsule("ray", ray, capsule);
}
template Truth<Passage<Surd>> ray_capsule(const Ray3d&, const Capsule3d&);
template Truth<Passage<Surd>> ray_capsule(const Ray3<Rational>&, const Capsule3<Rational>&);

}  // namespace touchstone::oracle
