// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/explicit_line.h"

#include "robust/kernel/filters/lessened.h"
#include "robust/kernel/integers/term_sum.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

Height height(int sign) { return sign > 0 ? Height::above : sign < 0 ? Height::below : Height::on; }

/// y - b - m x
std::array<kernel::Term, 3> elevation(double slope, double intercept, const Point2d& point) {
  return {kernel::term(point.y), -kernel::term(intercept), -kernel::term(slope, point.x)};
}

void validate_explicit_line(double slope, double intercept, const Point2d& point) {
  if (kernel::all_finite(slope, intercept) && kernel::valid(point)) return;
  validation::validate("slope", slope), validation::validate("intercept", intercept),
      validation::validate("point", point);
}

}  // namespace

Perhaps<Height> stages::explicit_line::lattice(double slope, double intercept, const Point2d& point) {
  const auto sum = kernel::lattice_sum(elevation(slope, intercept, point));
  if (!sum) return std::nullopt;
  return height(kernel::sign_of(sum->n));
}

Height stages::explicit_line::exact(double slope, double intercept, const Point2d& point) {
  return height(sgn(kernel::exact_sum(elevation(slope, intercept, point)).n));
}

namespace {

/// The filter again, if the guard may have failed: all heights over 2^700, and with them the slope or else x.
Perhaps<Height> filter_of_large(double slope, double intercept, Point2d point) {
  constexpr double large = 0x1p300;
  const bool steep = !(filters::FloatFormat<double>::magnitude(slope) <= large);
  if (!steep && filters::FloatFormat<double>::magnitude(point.x) <= large) return std::nullopt;
  kernel::Lessened lessened;
  double& factor = steep ? slope : point.x;
  factor = lessened(factor), intercept = lessened(intercept), point.y = lessened(point.y);
  if (!lessened.exact()) return std::nullopt;
  return stages::explicit_line::filter(slope, intercept, point);
}

}  // namespace

Decided<Height> stages::explicit_line::past_filter(double slope, double intercept, const Point2d& point) {
  if (const auto height = filter_of_large(slope, intercept, point)) return {*height, Stage::filter};
  return in_turn<explicit_line, validate_explicit_line, Stage::lattice, Stage::exact>(slope, intercept, point);
}

}  // namespace touchstone::robust
