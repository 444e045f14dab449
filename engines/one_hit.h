// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>
#include <touchstone/geometry/bodies.h>

#include <algorithm>
#include <cmath>
#include <optional>

/// How an engine that moves balls is asked about one collision: two balls of one radius that touch, one short step, no
/// gravity, no friction.
namespace touchstone::exactly {

template <class Real>
struct Hit {
  Vector3<Real> between;  // from the center of the first to that of the second
  Real distance;          // its length, between 1 and 4
  double approach;        // how fast the distance becomes less
};

/// Empty where the length of the normal is no number of the engine's: the balls would overlap or be apart a little; and
/// where they move across the normal alone. The normal may point either way: it is turned so that they approach.
template <class Real>
std::optional<Hit<Real>> hit(const Velocities<Real>& velocities, const Vector3<Real>& normal) {
  const int exponent = std::ilogb(std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}));
  const auto scaled = [exponent](Real c) { return std::scalbn(c, -exponent); };
  Vector3<Real> n{scaled(normal.x), scaled(normal.y), scaled(normal.z)};
  const auto lost = [exponent](Real c, Real of) { return std::scalbn(c, exponent) != of; };
  if (lost(n.x, normal.x) || lost(n.y, normal.y) || lost(n.z, normal.z)) return std::nullopt;

  const auto exact = [](Real c) { return mpq_class(static_cast<double>(c)); };
  const auto length = static_cast<Real>(std::sqrt(static_cast<double>(dot(n, n))));
  if (exact(length) * exact(length) != exact(n.x) * exact(n.x) + exact(n.y) * exact(n.y) + exact(n.z) * exact(n.z))
    return std::nullopt;
  const auto& [v, w] = velocities;
  const mpq_class speed = (exact(v.x) - exact(w.x)) * exact(n.x) + (exact(v.y) - exact(w.y)) * exact(n.y) +
                          (exact(v.z) - exact(w.z)) * exact(n.z);
  if (speed == 0) return std::nullopt;
  if (speed < 0) n = Real(-1) * n;
  const double displacement = static_cast<double>(n.x) * (static_cast<double>(v.x) - static_cast<double>(w.x)) +
                              static_cast<double>(n.y) * (static_cast<double>(v.y) - static_cast<double>(w.y)) +
                              static_cast<double>(n.z) * (static_cast<double>(v.z) - static_cast<double>(w.z));
  return Hit<Real>{n, length, displacement / static_cast<double>(length)};
}

}  // namespace touchstone::exactly
