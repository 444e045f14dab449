// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <touchstone/geometry/penetration.h>
#include <touchstone/oracle/mixed/penetration.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "surfaces.h"

/// Answers about the depth of convex solids for engines that give a depth and a direction.
namespace touchstone::depth {

/// Exactly: of the directions that are as deep as any, the one that is nearest to `direction`.
template <class Real>
Penetration<oracle::Surd> nearest(const Mesh<Real>& a, const Mesh<Real>& b, Real radius_a, Real radius_b,
                                  const Vector3<Real>& direction) {
  return oracle::as_deep(surfaces::in_double(a), surfaces::in_double(b), radius_a, radius_b,
                         {direction.x, direction.y, direction.z});
}

template <class Real>
Real rounded(const oracle::Surd& number) {
  return static_cast<Real>(oracle::Rational(number.enclosure(100).low).get_d());
}
template <class Real>
Vector3<Real> rounded(const Vector3<oracle::Surd>& v) {
  return {rounded<Real>(v.x), rounded<Real>(v.y), rounded<Real>(v.z)};
}

/// direction: of the translation of a. No engine here names the parts of both solids on which the direction rests: they
/// are those of the nearest one, so that contact, depth and direction alone are judged. An engine that has no direction
/// for a depth of 0 gets that one.
template <class Real>
Penetration<Real> answer(const Mesh<Real>& a, const Mesh<Real>& b, Real radius_a, Real radius_b, Real depth,
                         Vector3<Real> direction) {
  const auto& [x, y, z] = direction;
  const bool finite = std::isfinite(x) && std::isfinite(y) && std::isfinite(z), none = !(dot(direction, direction) > 0);
  if (depth != 0 && !finite) throw std::runtime_error("the direction is not finite");
  const auto deep = nearest<Real>(a, b, radius_a, radius_b, finite ? direction : Vector3<Real>{0, 0, 1});
  if (depth == 0 && none) direction = rounded<Real>(deep.direction);
  const Contact contact = depth > 0 ? Contact::overlapping : depth == 0 ? Contact::touching : Contact::disjoint;
  return {contact, depth, direction, depth * direction, deep.feature};
}

/// The answer of an engine that says `disjoint` and gives no distance: it is left out where it is right.
template <class Real>
std::optional<Penetration<Real>> apart(const Mesh<Real>& a, const Mesh<Real>& b, Real radius_a, Real radius_b) {
  const auto deep = nearest<Real>(a, b, radius_a, radius_b, {0, 0, 1});
  if (deep.contact == Contact::disjoint) return std::nullopt;
  return Penetration<Real>{Contact::disjoint, 0, rounded<Real>(deep.direction), {0, 0, 0}, deep.feature};
}

}  // namespace touchstone::depth
