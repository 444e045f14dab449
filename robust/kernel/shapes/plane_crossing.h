// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/filters/plane_filter.h"
#include "robust/kernel/filters/staged.h"
#include "robust/kernel/integers/plane_terms.h"

/// The point where a line from + t way crosses a plane. Its height over the plane, times |N|, is height + t climb.
namespace touchstone::robust::kernel {

/// The same in integers: heights over one power of two, positions over another.
struct CrossingLine {
  Scaled<mpz_class> height, climb;
  Integers<6> line;  // x, y, z of from, then of way

  /// Classifies the part with t >= 0, and t <= 1 if the line ends, that lies in the plane.
  LinePlaneRelation relation(bool ends) const;
  LinePlane<double> answer(bool ends) const;
};

/// Makes a and b multiples of one power of two.
void to_one_unit(Scaled<mpz_class>& a, Scaled<mpz_class>& b);

/// The answer if height and descent = -climb are known to have the same sign, and to give the only t in range.
inline Perhaps<LinePlane<double>> enclosed_crossing(const Enclosed<double>& height, const Enclosed<double>& descent,
                                                    const Point3d& from, const Factor<Two>& xy,
                                                    const Factor<double>& z) {
  const Enclosed<double> t = height / Divisor(descent);
  const auto parameter = rounded(t);
  const auto there = rounded(along(Two(from.x, from.y), twice(t), xy));
  const auto up = rounded(along(from.z, t, z));
  if (!parameter || !there || !up) return std::nullopt;
  return LinePlane<double>{LinePlaneRelation::point, parameter, Point3d{there->first(), there->second(), *up}};
}

}  // namespace touchstone::robust::kernel
