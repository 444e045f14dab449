// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/point_plane_toi.h"

#include <algorithm>

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {
namespace {

/// E along the step: height + t slope.
struct Step {
  Point3<Rational> start;
  Vector3<Rational> direction;
  Rational height, slope, squared_normal;
  Rational last() const { return Rational(height + slope); }
};

template <class Number>
Step examine(const Plane<Number>& plane, const Point3<Number>& start, const Point3<Number>& end) {
  validation::validate_all("plane", plane, "start", start, "end", end);
  const Plane<Rational> exactly = exact(plane);
  const Point3<Rational> from = exact(start);
  const Vector3<Rational> direction = exact(end) - from;
  return {from, direction, height_over(exactly, from), dot(exactly.normal, direction),
          dot(exactly.normal, exactly.normal)};
}

FirstHit<Rational> first_hit(const Step& step) {
  if (sgn(step.height) <= 0) return {HitRelation::hit, Rational(0), step.start};
  if (sgn(step.last()) > 0) return {HitRelation::never, std::nullopt, std::nullopt};
  const Rational t(-step.height / step.slope);  // it falls from above 0 to 0 or below
  return {HitRelation::hit, t, step.start + t * step.direction};
}

Truth<PointPlaneToi<Rational>> truth_point_plane_toi(const Step& step) {
  const Rational end(abs(step.last()));
  const Rational deciding = sgn(step.last()) > 0 ? std::min(end, Rational(abs(step.height))) : end;
  return {{{sgn(step.last()) > 0 ? HitRelation::never : HitRelation::hit}, first_hit(step)},
          Rational(deciding * deciding / step.squared_normal),
          [height = step.height, last = step.last()] {
            return Certificate{"heights", {{"heights", {height, last}}}};
          }};
}

}  // namespace

template <Exact Number>
Truth<PointPlaneToi<Rational>> point_plane_toi(const Plane<Number>& plane, const Point3<Number>& start,
                                               const Point3<Number>& end) {
  return truth_point_plane_toi(examine(plane, start, end));
}
template Truth<PointPlaneToi<Rational>> point_plane_toi(const Plane3d&, const Point3d&, const Point3d&);
template Truth<PointPlaneToi<Rational>> point_plane_toi(const Plane<Rational>&, const Point3<Rational>&,
                                                        const Point3<Rational>&);

}  // namespace touchstone::oracle
