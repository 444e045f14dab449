// SPDX-License-Identifier: Apache-2.0
#include "robust/hulls/facet.h"

#include <algorithm>

#include "robust/kernel/integers/lattice.h"
#include "robust/lines/orientation.h"

namespace touchstone::robust::hulls {
namespace {

/// On the wide lattice |q| < 2, so that differences are integers below 2^40.
std::array<std::int64_t, 3> difference(const FramePoint& p, const FramePoint& q) {
  const auto integer = [](double x) { return static_cast<std::int64_t>(x * 0x1p38); };
  return {integer(q.x - p.x), integer(q.y - p.y), integer(q.z - p.z)};
}

Point3d position(const FramePoint& p) { return {p.x, p.y, p.z}; }

}  // namespace

int Sides::turn(std::size_t i, std::size_t j, const FramePoint& a, const FramePoint& b, const FramePoint& c) const {
  const Side side =
      stages::orientation::ask(Point2d{a[i], a[j]}, Point2d{b[i], b[j]}, Point2d{c[i], c[j]}).noting(latest_);
  return side == Side::left ? 1 : side == Side::right ? -1 : 0;
}

bool Sides::collinear(const FramePoint& a, const FramePoint& b, const FramePoint& c) const {
  return turn(0, 1, a, b, c) == 0 && turn(1, 2, a, b, c) == 0 && turn(2, 0, a, b, c) == 0;
}

void Sides::lie_across(Facet& f, std::size_t k, const FramePoint& a, const FramePoint& b, const FramePoint& c) const {
  const int sign = turn((k + 1) % 3, (k + 2) % 3, a, b, c);
  f.n[0] = f.n[1] = f.n[2] = 0;
  f.n[k] = sign;
  f.d = sign * a[k];
}

/// The determinant is below 6 * 2^120.
int Sides::exactly(const Facet& f, const FramePoint& p, const std::vector<FramePoint>& points) const {
  const FramePoint &a = points[static_cast<std::size_t>(f.corner[0])],
                   &b = points[static_cast<std::size_t>(f.corner[1])],
                   &c = points[static_cast<std::size_t>(f.corner[2])];
  if (a.at(p) || b.at(p) || c.at(p)) return 0;
  latest_ = std::max(latest_, Stage::lattice);
  if (!wide_) {
    return in_turn<kernel::SideOfFace, Stage::lattice, Stage::exact>(position(a), position(b), position(c), position(p))
        .noting(latest_);
  }
  const auto u = difference(a, b), v = difference(a, c), w = difference(a, p);
  kernel::Int128 sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    sum += (kernel::Int128{u[i]} * v[j] - kernel::Int128{u[j]} * v[i]) * w[k];
  }
  return kernel::sign_of(sum);
}

}  // namespace touchstone::robust::hulls
