// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/face_part.h"

#include <algorithm>

#include "oracle/exact/shapes/nearest_pair.h"

namespace touchstone::oracle {

FacePart face_part(const std::vector<Point3<Rational>>& corners, const Point3<Rational>& x) {
  if (std::find(corners.begin(), corners.end(), x) != corners.end()) return FacePart::vertex;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Hull edge{corners[k], corners[(k + 1) % corners.size()]};
    if (sgn(nearest_pair(edge, {x}).squared_distance) == 0) return FacePart::edge;
  }
  return FacePart::inside;
}

}  // namespace touchstone::oracle
