// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/face_part.h"

namespace touchstone::robust::kernel {

FacePart face_part(const QuotientPoint& x, const std::vector<IntegerPoint>& corners) {
  FacePart found = FacePart::inside;
  const mpz_class zero = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto &from = corners[k], &to = corners[(k + 1) % corners.size()];
    const Vector3<mpz_class> edge = to - from, seen{x.n.x - x.d * from.x, x.n.y - x.d * from.y, x.n.z - x.d * from.z};
    if (dot(seen, seen) == zero) return FacePart::vertex;
    const Vector3<mpz_class> aside = cross(seen, edge);
    const mpz_class along = dot(seen, edge);
    if (dot(aside, aside) == zero && along >= zero && along <= x.d * dot(edge, edge)) found = FacePart::edge;
  }
  return found;
}

}  // namespace touchstone::robust::kernel
