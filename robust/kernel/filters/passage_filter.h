// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/filters/line_in_space.h"
#include "robust/kernel/filters/sized.h"
#include "robust/kernel/filters/staged.h"

/// Decides whether a line meets a box, or returns unknown. Numbers need not be valid.
namespace touchstone::robust::filters {

/// The numbers of an axis of a ray and a box.
struct RayOnAxis {
  double way, size_of_way, twice_start, reach, width;
  int beyond, open;  ///< the ray is certainly on one side of the box; certainly on none

  RayOnAxis(double from, double v, double min, double max) : way(v), size_of_way(FloatFormat<double>::magnitude(v)) {
    const double over = from - min, beneath = from - max;
    twice_start = over + beneath, reach = extent<double>(over, beneath), width = max - min;
    const int rises = v > 0, falls = v < 0, stays = validation::zero(v);
    beyond = ((over < -least) & (falls | stays)) | ((beneath > least) & (rises | stays));
    open = ((over > least) | rises) & ((beneath < -least) | falls);
  }

  /// 16 n: a difference of two numbers of the input that is computed beyond it has that sign (1).
  static constexpr double least = power_of_two(4 + FloatFormat<double>::min_exponent);
};

/// The separating axes of box_relation, for rays, with one bound for the three products: the model and rules of
/// filters.h.
///
/// With W the sum of all |v_i|, and S that of the reaches |from - min| + |from - max|: |c_j| and h_j, taken twice, are
/// at most the reach of their axis, so both parts of the difference are at most W S. A product goes through (1 + u)^4
/// in the first part, (1 + u)^3 in the second; the last subtraction is shared (4). (1 - u)^6 of W S is computed, and
/// the bound has three operations more: C (1 - u)^9 >= (1 + u) ((1 + u)^4 + (1 + u)^3 - 2) = 7 u + .... C = 7 u + 128
/// u^2: at u = 1/16, 2.058 < 2.143 in units of 7 u. Where W + S <= H, underflow costs less than 17 n H for each product
/// of the first part, 6 n H for each of the second, and 80 n H in the bound: 512 n H pays for them. (Looser by more
/// than two than it could be: the greatest pair of axes is a part of W S.) In the plane z = 0 the axis z separates
/// nothing, and x and y decide. Not proved by machine.
inline Perhaps<PassageRelation> ray_and_box(const Point3d& from, const Point3d& v, const Aabb3d& box) {
  using B = Bounds<double>;
  const RayOnAxis x(from.x, v.x, box.min.x, box.max.x), y(from.y, v.y, box.min.y, box.max.y),
      z(from.z, v.z, box.min.z, box.max.z);
  const double ways = x.size_of_way + y.size_of_way + z.size_of_way, reaches = x.reach + y.reach + z.reach;
  const double error = B::relative<14, 128>() * ways * reaches + B::absolute_of_several();
  const auto apart = [](const RayOnAxis& i, const RayOnAxis& j) {
    return FloatFormat<double>::magnitude(i.way * j.twice_start - j.way * i.twice_start) -
           (i.size_of_way * j.width + j.size_of_way * i.width);
  };
  const double xy = apart(x, y), yz = apart(y, z), zx = apart(z, x), least = RayOnAxis::least;
  const int flat =
      validation::zero(from.z) & validation::zero(v.z) & validation::zero(box.min.z) & validation::zero(box.max.z);
  const int solid = (x.width > least) & (y.width > least) & ((z.width > least) | flat);
  const int valid = solid & (ways > 0) & (ways + reaches <= B::high());
  const int misses = x.beyond | y.beyond | z.beyond | (xy > error) | (yz > error) | (zx > error);
  const int meets = x.open & y.open & (xy < -error) & ((z.open & (yz < -error) & (zx < -error)) | flat);
  if ((valid & (misses + meets)) == 0) [[unlikely]]  // one branch: the answer is unpredictable
    return std::nullopt;
  return misses != 0 ? PassageRelation::none : PassageRelation::hit;
}

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
  if (!ends) {
    if (const auto answer = ray_and_box(from, to, box)) return answer;
  }
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
  const int misses = x.beyond | y.beyond | z.beyond | xy.positive() | yz.positive() | zx.positive();
  const int meets = xy.not_positive() & yz.not_positive() & zx.not_positive();
  if (misses + meets == 0) [[unlikely]]  // one branch
    return std::nullopt;
  return misses != 0 ? PassageRelation::none : PassageRelation::hit;
}

}  // namespace touchstone::robust::filters
