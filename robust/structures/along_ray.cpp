// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/along_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robust/kernel/integers/dyadic.h"

namespace touchstone::robust::structures {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using kernel::Dyadic;

/// For a = p / q and b = r / s: the sign of p s - r q, times that of q s.
int compare_exactly(const Moment& a, const Moment& b) {
  const auto displacement = [](const Moment& m) { return Dyadic(kernel::dyadic(m.bound) - kernel::dyadic(m.origin)); };
  const Dyadic over = displacement(a) * kernel::dyadic(b.direction) - displacement(b) * kernel::dyadic(a.direction);
  return (a.direction < 0) == (b.direction < 0) ? sgn(over.n) : -sgn(over.n);
}

}  // namespace

Moment::Moment(double to, double from, double step) : bound(to), origin(from), direction(step) {
  const double t = (to - from) / step, size = std::fabs(t);
  const bool bounded = size <= 0x1p1000;
  const double error = 0x1p-51 * size + 0x1p-1074;
  low = bounded ? t - error : -infinity;
  high = bounded ? t + error : infinity;
}

int compare(const Moment& a, const Moment& b) {
  if (a.high < b.low) return -1;
  if (b.high < a.low) return 1;
  const bool same = a.bound == b.bound && a.origin == b.origin && a.direction == b.direction;
  return same ? 0 : compare_exactly(a, b);
}

/// The ray is in the box from the last entry of any axis to the first exit of one.
std::optional<Moment> first_moment(const Ray3d& ray, const Aabb3d& box) {
  Moment entry;
  std::optional<Moment> exit;
  const auto cut = [&](double from, double step, double low, double high) {
    if (step == 0) return low <= from && from <= high;
    const Moment enter(step > 0 ? low : high, from, step), leave(step > 0 ? high : low, from, step);
    if (compare(entry, enter) < 0) entry = enter;
    if (!exit || compare(leave, *exit) < 0) exit = leave;
    return compare(entry, *exit) <= 0;
  };
  const auto& [o, d] = ray;
  const bool met =
      cut(o.x, d.x, box.min.x, box.max.x) && cut(o.y, d.y, box.min.y, box.max.y) && cut(o.z, d.z, box.min.z, box.max.z);
  if (!met) return std::nullopt;
  return entry;
}

std::vector<Index> in_order(std::vector<std::pair<Moment, Index>> met) {
  std::sort(met.begin(), met.end(), [](const auto& a, const auto& b) {
    const int order = compare(a.first, b.first);
    return order != 0 ? order < 0 : a.second < b.second;
  });
  std::vector<Index> bodies;
  for (const auto& [moment, body] : met) bodies.push_back(body);
  return bodies;
}

}  // namespace touchstone::robust::structures
