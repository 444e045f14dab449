// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/face_side.h"

#include "robust/kernel/shapes/plane.h"

namespace touchstone::robust::kernel {
namespace {

/// Differences are below 2^62 on a lattice, their products below 2^124, the normal's coordinates below 2^125, the value
/// below 2^189.
template <class Integer>
int side_of(const std::array<Integer, 12>& n) {
  const auto from_a = [&n](std::size_t i) {
    return Vector3<Integer>{Integer(n[i] - n[0]), Integer(n[i + 1] - n[1]), Integer(n[i + 2] - n[2])};
  };
  const Vector3<Integer> v = from_a(3), w = from_a(6), d = from_a(9);
  const Second<Integer> x = multiply(v.y, w.z) - multiply(v.z, w.y), y = multiply(v.z, w.x) - multiply(v.x, w.z),
                        z = multiply(v.x, w.y) - multiply(v.y, w.x);
  return sign_of(Third<Integer>(multiply(x, d.x) + multiply(y, d.y) + multiply(z, d.z)));
}

}  // namespace

Perhaps<int> SideOfFace::lattice(const Point3d& a, const Point3d& b, const Point3d& c, const Point3d& p) {
  const auto lattice = lattice_of(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, p.x, p.y, p.z);
  if (!lattice) return std::nullopt;
  return side_of(lattice->at);
}

int SideOfFace::exact(const Point3d& a, const Point3d& b, const Point3d& c, const Point3d& p) {
  return side_of(integers_of(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, p.x, p.y, p.z).at);
}

Decided<int> FaceSide::past_filter(const Point3d& p) const {
  return in_turn<SideOfFace, Stage::lattice, Stage::exact>(a_, b_, c_, p);
}

}  // namespace touchstone::robust::kernel
