// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/line_point_at.h"

#include "robust/kernel/enclosed/push.h"
#include "robust/kernel/enclosed/window.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/integers/term_sum.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// Only the lower bound of the window is checked. A number that is too large makes the product or the sum infinite, of
/// which two_sum makes NaN, and that is not enclosed.
[[gnu::always_inline]] inline std::optional<kernel::Two> enclosed_point(const ParametricLine2d& line, double t) {
  using namespace kernel;
  if (validation::zero(line.direction.x) && validation::zero(line.direction.y)) return std::nullopt;  // refused
  const Two origin(line.origin), direction(line.direction), parameter(t);
  if (!none_small(origin, direction, parameter) || !rounds_to_nearest()) return std::nullopt;
  return enclosed_push(origin, share(parameter), factor(direction));
}

}  // namespace

Perhaps<Point2d> stages::line_point_at::enclosed(const ParametricLine2d& line, double t) {
  if (const auto point = enclosed_point(line, t)) return Point2d{point->first(), point->second()};
  return std::nullopt;
}

namespace {

/// origin + t direction, along one axis
std::array<kernel::Term, 2> coordinate(double origin, double direction, double t) {
  return {kernel::term(origin), kernel::term(t, direction)};
}

std::optional<double> on_lattice(double origin, double direction, double t) {
  const auto sum = kernel::lattice_sum(coordinate(origin, direction, t));
  if (!sum) return std::nullopt;
  return kernel::round_scaled(sum->n, sum->exponent);
}

double on_integers(double origin, double direction, double t) {
  const auto sum = kernel::exact_sum(coordinate(origin, direction, t));
  return kernel::round_scaled(sum.n, sum.exponent);
}

}  // namespace

Perhaps<Point2d> stages::line_point_at::lattice(const ParametricLine2d& line, double t) {
  const auto x = on_lattice(line.origin.x, line.direction.x, t), y = on_lattice(line.origin.y, line.direction.y, t);
  if (!x || !y) return std::nullopt;
  return Point2d{*x, *y};
}

Point2d stages::line_point_at::exact(const ParametricLine2d& line, double t) {
  return {on_integers(line.origin.x, line.direction.x, t), on_integers(line.origin.y, line.direction.y, t)};
}

namespace {

void validate_line_point_at(const ParametricLine2d& line, double t) {
  if (kernel::valid(line) && kernel::all_finite(t)) return;
  validation::validate_all("line", line, "t", t);
}

/// Out of line, so that the usual path has no registers to save.
[[gnu::noinline]] Point2d past_enclosure(const ParametricLine2d& line, double t) {
  return answer_in_turn<stages::line_point_at, validate_line_point_at, Stage::lattice, Stage::exact>(line, t);
}

}  // namespace

Decided<Point2d> stages::line_point_at::ask(const ParametricLine2d& line, double t) {
  return in_turn<line_point_at, Stage::enclosed, validate_line_point_at, Stage::lattice, Stage::exact>(line, t);
}

Point2d line_point_at(const ParametricLine2d& line, double t) {
  if (const auto point = enclosed_point(line, t)) return Point2d{point->first(), point->second()};
  return past_enclosure(line, t);
}

}  // namespace touchstone::robust
