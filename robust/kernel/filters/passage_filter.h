// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "robust/kernel/filters/decode.h"
#include "robust/kernel/filters/line_in_space.h"
#include "robust/kernel/filters/sized.h"
#include "robust/kernel/filters/staged.h"
#include "robust/kernel/filters/sweep_filter.h"

/// Decides whether a line meets a box or a ball, or returns unknown. Numbers need not be valid.
namespace touchstone::robust::filters {

/// The numbers of an axis: the line's displacement along it, twice its start relative to the box's center, and the
/// box's width.
struct OfAxis {
  Sized<1> way;
  Sized<2> twice_start;
  Sized<1> width;
  int beyond;  ///< the line is on one side of the box

  OfAxis(double from, double to, bool ends, double min, double max)
      : way(ends ? sized_difference(to, from) : Sized<1>{to, FloatFormat<double>::magnitude(to)}),
        twice_start(sized_difference(from, min) + sized_difference(from, max)),
        width(sized_difference(max, min)),
        beyond(((from < min) & (ends ? to < min : to <= 0)) | ((from > max) & (ends ? to > max : to >= 0))) {}
};

/// Separating axes: those of the box, which comparisons decide, and those perpendicular to the line and one of them,
/// where |v_i c_j - v_j c_i| is compared with the box's half extent, |v_i| h_j + |v_j| h_i. One of these six separates
/// every line that misses a box. Touching is a hit.
inline Perhaps<PassageRelation> box_relation(const kernel::Line& line, const kernel::Box& box) {
  const auto& [from, to, ends] = line;
  if (!(moderate(from) & moderate(to) & moderate(box.min) & moderate(box.max))) return std::nullopt;
  if (!((box.min.x <= box.max.x) & (box.min.y <= box.max.y) & (box.min.z <= box.max.z))) return std::nullopt;
  const OfAxis x(from.x, to.x, ends, box.min.x, box.max.x), y(from.y, to.y, ends, box.min.y, box.max.y),
      z(from.z, to.z, ends, box.min.z, box.max.z);
  if (!ends && (x.way.size == 0) & (y.way.size == 0) & (z.way.size == 0)) return std::nullopt;  // to be refused
  const auto apart = [](const OfAxis& i, const OfAxis& j) {
    return magnitude(i.way * j.twice_start - j.way * i.twice_start) -
           (magnitude(i.way) * j.width + magnitude(j.way) * i.width);
  };
  const auto xy = apart(x, y), yz = apart(y, z), zx = apart(z, x);
  if (x.beyond | y.beyond | z.beyond | xy.positive() | yz.positive() | zx.positive()) return PassageRelation::none;
  if (xy.not_positive() & yz.not_positive() & zx.not_positive()) return PassageRelation::hit;
  return std::nullopt;
}

/// Decides by the signs that sweep_filter.h proves, for a point that moves along the line.
inline Perhaps<PassageRelation> ball_relation(const kernel::Line& line, const kernel::Ball& ball) {
  if (kernel::sign_bit(ball.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
  const auto& [from, to, ends] = line;
  const Point3d base = ends ? from : Point3d{0, 0, 0};
  const Sweep<double> sweep({from, 0}, ball, {to.x, to.y, to.z}, {base.x, base.y, base.z});
  const Sign start = sweep.start();
  if (start == Sign::unknown) return std::nullopt;
  const Sign slope = sweep.slope_at_start();
  if (start == Sign::negative) {
    if (slope == Sign::unknown) return std::nullopt;  // perhaps a zero direction, to be refused
    return PassageRelation::hit;
  }
  if (slope == Sign::positive) return PassageRelation::none;
  const Sign passage = sweep.passage();
  if (passage == Sign::positive) return PassageRelation::none;
  if (slope == Sign::unknown) return std::nullopt;
  if (!ends) return by_sign(passage, PassageRelation::none, PassageRelation::hit);
  const Sign end = sweep.end(), slope_at_end = sweep.slope_at_end();
  if (end == Sign::negative) return PassageRelation::hit;
  if (end == Sign::unknown || slope_at_end == Sign::unknown || passage == Sign::unknown) return std::nullopt;
  return slope_at_end == Sign::negative ? PassageRelation::none : PassageRelation::hit;
}

}  // namespace touchstone::robust::filters
