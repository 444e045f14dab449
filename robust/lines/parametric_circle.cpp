// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/parametric_circle.h"

#include <cstdint>

#include "robust/kernel/enclosed/window.h"
#include "robust/kernel/integers/enclosed_angles.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/integers/sine_cosine.h"
#include "robust/kernel/integers/term_sum.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {

Perhaps<Point2d> stages::parametric_circle::enclosed(const Circle2d& circle, double u) {
  using namespace kernel;
  const Two center(circle.center), radius(circle.radius);
  if (!in_window(center, Two(circle.radius, u)) || !rounds_to_nearest()) return std::nullopt;
  const auto direction = enclosed_cosine_sine(u);
  if (!direction || !direction->settled()) return std::nullopt;
  const auto point = rounded(along(center, factor(*direction), direction->error, factor(radius)));
  if (!point) return std::nullopt;
  return Point2d{point->first(), point->second()};
}

namespace {

using kernel::Scaled;

Scaled<mpz_class> integer(double value) { return kernel::exact_sum<1>({kernel::term(value)}); }

/// a + b
Scaled<mpz_class> sum(const Scaled<mpz_class>& a, const Scaled<mpz_class>& b) {
  const int low = std::min(a.exponent, b.exponent);
  return {(a.n << static_cast<std::uint64_t>(a.exponent - low)) + (b.n << static_cast<std::uint64_t>(b.exponent - low)),
          low};
}

/// center + radius * factor rounded, for a factor within error of n, both in units of 2^-bits; empty if that could be
/// two doubles.
std::optional<double> coordinate(const Scaled<mpz_class>& center, const Scaled<mpz_class>& radius, const mpz_class& n,
                                 const mpz_class& error, std::uint64_t bits) {
  const int exponent = radius.exponent - static_cast<int>(bits);
  const Scaled<mpz_class> low = sum(center, {radius.n * (n - error), exponent});
  const Scaled<mpz_class> high = sum(center, {radius.n * (n + error), exponent});
  const double below = kernel::round_scaled(low.n, low.exponent), above = kernel::round_scaled(high.n, high.exponent);
  if (std::bit_cast<std::uint64_t>(below) != std::bit_cast<std::uint64_t>(above)) return std::nullopt;
  return below;
}

double sum_rounded(double a, double b) {
  const Scaled<mpz_class> exact = kernel::exact_sum<2>({kernel::term(a), kernel::term(b)});
  return kernel::round_scaled(exact.n, exact.exponent);
}

void validate_parametric_circle(const Circle2d& circle, double u) {
  if (kernel::valid(circle) && kernel::all_finite(u)) return;
  validation::validate_all("circle", circle, "u", u);
}

}  // namespace

Point2d stages::parametric_circle::exact(const Circle2d& circle, double u) {
  const Point2d& c = circle.center;
  if (validation::zero(circle.radius)) return {sum_rounded(c.x, 0), sum_rounded(c.y, 0)};
  if (validation::zero(u)) return {sum_rounded(c.x, circle.radius), sum_rounded(c.y, 0)};
  // The sine and cosine of a rational number other than 0 are transcendental (Lindemann), so both coordinates are:
  // never zero, never a double, never halfway between two. Some precision therefore decides on which side of every such
  // number they lie.
  const Scaled<mpz_class> x = integer(c.x), y = integer(c.y), radius = integer(circle.radius);
  std::optional<double> across, up;
  // A small angle has a small sine: its leading zeros are not significant digits.
  const kernel::Decoded angle = kernel::decode(u);
  std::uint64_t bits = 128 + static_cast<std::uint64_t>(std::max(0, -angle.exponent - 53));
  for (; !across || !up; bits *= 2) {
    const kernel::SineCosine at = kernel::sine_cosine(u, bits);
    if (!across) across = coordinate(x, radius, at.cosine, at.error, bits);
    if (!up) up = coordinate(y, radius, at.sine, at.error, bits);
  }
  return {*across, *up};
}

Decided<Point2d> stages::parametric_circle::ask(const Circle2d& circle, double u) {
  return in_turn<parametric_circle, validate_parametric_circle, Stage::enclosed, Stage::exact>(circle, u);
}

Point2d parametric_circle(const Circle2d& circle, double u) { return stages::parametric_circle::ask(circle, u).answer; }

}  // namespace touchstone::robust
