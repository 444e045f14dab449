// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/orientation.h"

#include "robust/kernel/valid.h"
#include "robust/kernel/plane.h"

namespace touchstone::robust {
namespace {

// Without branches: near a line nobody can predict the side.
Side side(int turn) {
  static_assert(static_cast<int>(Side::left) == 0 && static_cast<int>(Side::on) == 1 &&
                static_cast<int>(Side::right) == 2);
  return static_cast<Side>(1 - turn);
}

template <class Integer>
Side side_of(const std::array<Integer, 6>& n) {
  return side(kernel::turn(Point2<Integer>{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}));
}

void validate(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  if (kernel::valid(p0) && kernel::valid(p1) && kernel::valid(p)) return;
  validation::validate("p0", p0), validation::validate("p1", p1), validation::validate("p", p);
}

}  // namespace

std::optional<Side> orientation_lattice(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const auto lattice = kernel::lattice_of(p0.x, p0.y, p1.x, p1.y, p.x, p.y);
  if (!lattice) return std::nullopt;
  return side_of(lattice->at);
}

Side orientation_exact(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  return side_of(kernel::integers_of(p0.x, p0.y, p1.x, p1.y, p.x, p.y).at);
}

Side orientation_past_filter(const Point2d& p0, const Point2d& p1, const Point2d& p, Stage& decided) {
  decided = Stage::lattice;
  // Not orientation_lattice: an optional answer is put together in memory, which costs as much as the determinant.
  // Numbers on a lattice are finite: nothing to validate.
  if (const auto lattice = kernel::lattice_of(p0.x, p0.y, p1.x, p1.y, p.x, p.y)) return side_of(lattice->at);
  validate(p0, p1, p);
  decided = Stage::exact;
  return orientation_exact(p0, p1, p);
}

}  // namespace touchstone::robust
