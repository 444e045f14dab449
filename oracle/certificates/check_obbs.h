// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "oracle/certificates/check_space.h"

namespace touchstone::certify {

/// The points center + r u + s v + t w with r, s, t in [-1, 1]; the half axes u, v, w are linearly independent.
struct Obb {
  Triple center;
  std::array<Triple, 3> half_axes;

  Triple at(const std::vector<Rational>& coefficients) const;
  /// The sum of |normal . half axis|: its extent from its center to either side, in units of the normal.
  Rational reach(const Triple& normal) const;
};

/// The greatest magnitude of three coefficients, a fact of this name.
Rational greatest(const std::vector<Rational>& coefficients, const std::string& name);

Obb obb(const json& value, const std::string& what);

}  // namespace touchstone::certify
