// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/explicit_line.h"

#include "robust/kernel/plane.h"
#include "robust/kernel/term_sum.h"
#include "robust/kernel/valid.h"

namespace touchstone::robust {
namespace {

Height height(int sign) { return sign > 0 ? Height::above : sign < 0 ? Height::below : Height::on; }

/// y - b - m x
std::array<kernel::Term, 3> elevation(double slope, double intercept, const Point2d& point) {
  return {kernel::term(point.y), -kernel::term(intercept), -kernel::term(slope, point.x)};
}

void validate(double slope, double intercept, const Point2d& point) {
  if (kernel::all_finite(slope, intercept) && kernel::valid(point)) return;
  validation::validate("slope", slope), validation::validate("intercept", intercept),
      validation::validate("point", point);
}

}  // namespace

std::optional<Height> explicit_line_lattice(double slope, double intercept, const Point2d& point) {
  const auto sum = kernel::lattice_sum(elevation(slope, intercept, point));
  if (!sum) return std::nullopt;
  return height(kernel::sign_of(sum->n));
}

Height explicit_line_exact(double slope, double intercept, const Point2d& point) {
  return height(kernel::sign_by_cgal(kernel::exact_sum(elevation(slope, intercept, point)).n));
}

Height explicit_line_past_filter(double slope, double intercept, const Point2d& point, Stage& decided) {
  validate(slope, intercept, point);
  decided = Stage::lattice;
  if (const auto answer = explicit_line_lattice(slope, intercept, point)) return *answer;
  decided = Stage::exact;
  return explicit_line_exact(slope, intercept, point);
}

}  // namespace touchstone::robust
