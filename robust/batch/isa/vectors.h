// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/triangles.h"

namespace touchstone::robust::batch::isa {
namespace {

Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
InSpace operator+(const InSpace& a, const InSpace& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
InSpace operator*(Lanes t, const InSpace& a) { return {t * a.x, t * a.y, t * a.z}; }
Lanes dot(const InSpace& a, const InSpace& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
InSpace cross(const InSpace& a, const InSpace& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
InSpace magnitudes(const InSpace& a) { return {magnitude(a.x), magnitude(a.y), magnitude(a.z)}; }
Lanes size_of(const InSpace& a) { return magnitude(a.x) + magnitude(a.y) + magnitude(a.z); }

}  // namespace
}  // namespace touchstone::robust::batch::isa
