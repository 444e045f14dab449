// SPDX-License-Identifier: Apache-2.0
#include "report/figures/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "catalogue/numbers/ulps.h"

namespace touchstone::report {
namespace {

constexpr std::size_t readable_digits = 6;
constexpr std::size_t most_grid_lines = 40;
constexpr double label_half = 3.2, room_right = 8;  // of a letter; beyond the frame

mpq_class power_of_ten(std::int64_t exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<std::uint64_t>(std::abs(exponent)));
  return exponent < 0 ? mpq_class(mpz_class(1), power) : mpq_class(power);
}

/// The least of 1, 2, 5 times a power of ten that divides the span into at most five steps.
struct Step {
  mpz_class factor;
  std::int64_t exponent = 0;
  mpq_class size;
};

Step round_step(const mpq_class& span) {
  mp_exp_t digits = 0;
  mpf_class(span, 128).get_str(digits, 10, 1);
  for (std::int64_t exponent = static_cast<std::int64_t>(digits) - 3;; ++exponent) {
    for (const int factor : {1, 2, 5}) {
      const mpq_class size = factor * power_of_ten(exponent);
      if (5 * size >= span) return {factor, exponent, size};
    }
  }
}

mpz_class floor_of(const mpq_class& value) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return result;
}

struct Tick {
  double pixel;
  std::string label;
};

/// Empty if the labels would need too many digits to differ.
std::vector<Tick> ticks_between(const mpq_class& low, const mpq_class& high, const mpq_class& per_unit) {
  const Step step = round_step(mpq_class(high - low));
  std::vector<Tick> found;
  for (mpz_class n = floor_of(mpq_class(low / step.size)) + 1; n * step.size < high; ++n) {
    const mpz_class value = n * step.factor;
    if (mpz_class(abs(value)).get_str().size() > readable_digits) return {};
    const mpq_class at = n * step.size;
    found.push_back({mpq_class((at - low) * per_unit).get_d(), about(at, readable_digits)});
  }
  return found;
}

std::string span_in_words(const char* axis, const mpq_class& low, const mpq_class& high) {
  return std::string(axis) + " = " + about(mpq_class((low + high) / 2), 9) + " \u00b1 " +
         about(mpq_class((high - low) / 2), 2);
}

/// Doubles near `value` within [low, high], in pixels from low.
std::vector<double> doubles_between(double value, const mpq_class& low, const mpq_class& high,
                                    const mpq_class& per_unit) {
  std::vector<double> found;
  for (const double end : {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}) {
    double at = end < 0 ? value : std::nextafter(value, end);
    while (std::isfinite(at)) {
      const mpq_class exact = exact_value(at);
      if (exact < low || exact > high) break;
      found.push_back(mpq_class((exact - low) * per_unit).get_d());
      if (found.size() > most_grid_lines) return found;
      at = std::nextafter(at, end);
    }
  }
  return found;
}

}  // namespace

mpq_class round_length(const mpq_class& span) { return round_step(span).size; }

std::string ticks(const Viewport& view) {
  const Frame& frame = view.frame();
  const ExactPoint low = view.corner(), high = view.far_corner();
  std::string svg;
  const std::vector<Tick> across = ticks_between(low.x, high.x, view.pixels_per_unit_x());
  for (const Tick& tick : across) {
    // At the right border the text ends where the figure does.
    const bool last = tick.pixel + label_half * static_cast<double>(tick.label.size()) > frame.width + room_right;
    svg += fmt::format(
        "<path class=\"tick\" d=\"M{} {}v5\"/><text class=\"scale\" x=\"{}\" y=\"{}\" "
        "text-anchor=\"{}\">{}</text>",
        pixels(tick.pixel), pixels(frame.height), pixels(last ? frame.width + room_right : tick.pixel),
        pixels(frame.height + 17), last ? "end" : "middle", tick.label);
  }
  if (across.empty()) {
    svg += fmt::format("<text class=\"scale\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                       pixels(frame.width / 2), pixels(frame.height + 17), span_in_words("x", low.x, high.x));
  }
  const std::vector<Tick> up = ticks_between(low.y, high.y, view.pixels_per_unit_y());
  for (const Tick& tick : up) {
    const double y = frame.height - tick.pixel;
    svg += fmt::format(
        "<path class=\"tick\" d=\"M0 {}h-5\"/><text class=\"scale\" x=\"-8\" y=\"{}\" text-anchor=\"end\">{}</text>",
        pixels(y), pixels(y + 4), tick.label);
  }
  if (up.empty()) {
    svg += fmt::format(
        "<text class=\"scale\" transform=\"translate(-10 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
        pixels(frame.height / 2), span_in_words("y", low.y, high.y));
  }
  return svg;
}

DoubleGrid double_grid(const Viewport& view, double x, double y) {
  const Frame& frame = view.frame();
  const ExactPoint low = view.corner(), high = view.far_corner();
  const std::vector<double> across = doubles_between(x, low.x, high.x, view.pixels_per_unit_x());
  const std::vector<double> up = doubles_between(y, low.y, high.y, view.pixels_per_unit_y());
  DoubleGrid grid;
  const std::size_t least = std::min(across.size(), up.size()), most = std::max(across.size(), up.size());
  if (most <= 1) grid.caption = "the next doubles are outside of this frame";
  if (most <= 1 || least > most_grid_lines) return grid;
  grid.caption = "thin lines: neighbouring doubles";
  if (across.size() <= most_grid_lines) {
    for (const double at : across)
      grid.svg += fmt::format("<path class=\"double\" d=\"M{} 0v{}\"/>", pixels(at), pixels(frame.height));
  }
  if (up.size() <= most_grid_lines) {
    for (const double at : up)
      grid.svg +=
          fmt::format("<path class=\"double\" d=\"M0 {}h{}\"/>", pixels(frame.height - at), pixels(frame.width));
  }
  return grid;
}

}  // namespace touchstone::report
