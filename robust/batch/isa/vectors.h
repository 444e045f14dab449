// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/kernels.h"

namespace touchstone::robust::batch::isa {
namespace {

struct InSpace {
  Lanes x, y, z;
  explicit InSpace(const Lanes* c) : x(c[0]), y(c[1]), z(c[2]) {}
  InSpace(Lanes x, Lanes y, Lanes z) : x(x), y(y), z(z) {}
  friend InSpace operator-(const InSpace& a, const InSpace& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
InSpace operator+(const InSpace& a, const InSpace& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
InSpace operator*(Lanes t, const InSpace& a) { return {t * a.x, t * a.y, t * a.z}; }
Lanes dot(const InSpace& a, const InSpace& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
InSpace cross(const InSpace& a, const InSpace& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
InSpace magnitudes(const InSpace& a) { return {magnitude(a.x), magnitude(a.y), magnitude(a.z)}; }
InSpace greater(const InSpace& a, const InSpace& b) {
  return {greater(a.x, b.x), greater(a.y, b.y), greater(a.z, b.z)};
}
Lanes greatest(const InSpace& a) { return greater(greater(a.x, a.y), a.z); }
Lanes size_of(const InSpace& a) { return magnitude(a.x) + magnitude(a.y) + magnitude(a.z); }

}  // namespace
}  // namespace touchstone::robust::batch::isa
