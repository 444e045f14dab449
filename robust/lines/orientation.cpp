// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/orientation.h"

#include "robust/kernel/legal.h"
#include "robust/kernel/plane.h"

namespace touchstone::robust {
namespace {

// Without branches: near a line nobody can predict the side.
Side side(int turn) {
  static_assert(static_cast<int>(Side::left) == 0 && static_cast<int>(Side::on) == 1 &&
                static_cast<int>(Side::right) == 2);
  return static_cast<Side>(1 - turn);
}

void admit(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  if (kernel::legal(p0) && kernel::legal(p1) && kernel::legal(p)) return;
  door::admit("p0", p0), door::admit("p1", p1), door::admit("p", p);
}

}  // namespace

std::optional<Side> orientation_lattice(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const auto lattice = kernel::lattice_of(p0.x, p0.y, p1.x, p1.y, p.x, p.y);
  if (!lattice) return std::nullopt;
  const auto& n = lattice->at;
  return side(kernel::turn(Point2<std::int64_t>{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}));
}

Side orientation_exact(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const auto n = kernel::integers_of(p0.x, p0.y, p1.x, p1.y, p.x, p.y).at;
  return side(kernel::turn(Point2<mpz_class>{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}));
}

Side orientation_past_filter(const Point2d& p0, const Point2d& p1, const Point2d& p, Stage& decided) {
  decided = Stage::lattice;
  if (const auto answer = orientation_lattice(p0, p1, p)) return *answer;  // all finite
  admit(p0, p1, p);
  decided = Stage::exact;
  return orientation_exact(p0, p1, p);
}

}  // namespace touchstone::robust
