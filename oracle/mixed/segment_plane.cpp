// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/segment_plane.h"

#include <algorithm>

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/shapes/line_plane.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<LinePlane<Rational>> segment_plane(const Segment3<Number>& segment, const Plane<Number>& plane) {
  validation::validate_all("segment", segment, "plane", plane);
  const LinePlaneHeights heights(exact(segment.a), exact(segment.b), exact(plane));
  return {heights.common(true),
          std::min(heights.squared_distance(heights.at_start()), heights.squared_distance(heights.at_end())),
          [=] { return heights.certificate(); }};
}
template Truth<LinePlane<Rational>> segment_plane(const Segment3d&, const Plane3d&);
template Truth<LinePlane<Rational>> segment_plane(const Segment3<Rational>&, const Plane<Rational>&);

}  // namespace touchstone::oracle
