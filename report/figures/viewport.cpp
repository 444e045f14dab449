// SPDX-License-Identifier: Apache-2.0
#include "report/figures/viewport.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "catalogue/numbers/ulps.h"

namespace touchstone::report {
namespace {

constexpr double far_outside = 20000;
constexpr int padding_percent = 15;
constexpr int most_apart_on_one_scale = 6;

/// The size assigned to an extent of zero: that of the coordinates themselves, or 1 at the origin.
mpq_class natural_extent(const mpq_class& x, const mpq_class& y) {
  const mpq_class size = std::max(mpq_class(abs(x)), mpq_class(abs(y)));
  return sgn(size) == 0 ? mpq_class(1) : size;
}

double clamped(const mpq_class& value) {
  if (value > far_outside) return far_outside;
  if (value < -far_outside) return -far_outside;
  return value.get_d();
}

}  // namespace

ExactPoint exact_point(double x, double y) { return {exact_value(x), exact_value(y)}; }

std::string pixels(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

Viewport Viewport::fitted(const std::vector<ExactPoint>& points, const Frame& frame, bool equal) {
  ExactPoint low{0, 0}, high{0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [x, y] = points[i];
    low = i == 0 ? points[i] : ExactPoint{x < low.x ? x : low.x, y < low.y ? y : low.y};
    high = i == 0 ? points[i] : ExactPoint{std::max(x, high.x), std::max(y, high.y)};
  }
  mpq_class wide = high.x - low.x, tall = high.y - low.y;
  if (sgn(wide) == 0 && sgn(tall) == 0) wide = tall = natural_extent(low.x, low.y);
  if (sgn(wide) == 0) wide = tall;
  if (sgn(tall) == 0) tall = wide;
  const bool one_scale = equal || (wide <= most_apart_on_one_scale * tall && tall <= most_apart_on_one_scale * wide);
  Viewport view;
  view.frame_ = frame;
  const mpq_class room(100 - 2 * padding_percent, 100);
  view.per_x_ = mpq_class(frame.width) * room / wide;
  view.per_y_ = mpq_class(frame.height) * room / tall;
  if (one_scale) view.per_x_ = view.per_y_ = view.per_x_ < view.per_y_ ? view.per_x_ : view.per_y_;
  view.left_ = (low.x + high.x) / 2 - mpq_class(frame.width) / view.per_x_ / 2;
  view.bottom_ = (low.y + high.y) / 2 - mpq_class(frame.height) / view.per_y_ / 2;
  return view;
}

Viewport Viewport::around(const ExactPoint& centre, const mpq_class& half, const Frame& frame) {
  Viewport view;
  view.frame_ = frame;
  view.per_x_ = view.per_y_ = mpq_class(std::min(frame.width, frame.height)) / 2 / half;
  view.left_ = centre.x - mpq_class(frame.width) / 2 / view.per_x_;
  view.bottom_ = centre.y - mpq_class(frame.height) / 2 / view.per_y_;
  return view;
}

ExactPoint Viewport::exactly(const ExactPoint& point) const {
  return {mpq_class((point.x - left_) * per_x_), mpq_class(frame_.height - (point.y - bottom_) * per_y_)};
}

Pixel Viewport::at(const ExactPoint& point) const {
  const ExactPoint exact = exactly(point);
  return {clamped(exact.x), clamped(exact.y)};
}

bool Viewport::shows(const ExactPoint& point) const {
  const ExactPoint p = exactly(point);
  return p.x >= 0 && p.y >= 0 && p.x <= frame_.width && p.y <= frame_.height;
}

ExactPoint Viewport::far_corner() const {
  return {mpq_class(left_ + mpq_class(frame_.width) / per_x_), mpq_class(bottom_ + mpq_class(frame_.height) / per_y_)};
}

std::vector<Pixel> clipped(const Viewport& view, const ExactPoint& a, const ExactPoint& b, const Stretch& stretch,
                           double margin) {
  const ExactPoint from = view.exactly(a), to = view.exactly(b);
  const mpq_class dx = to.x - from.x, dy = to.y - from.y;
  std::optional<mpq_class> first, last;
  if (!stretch.before) first = 0;
  if (!stretch.beyond) last = 1;
  // Each side of the frame as start + t step >= 0.
  const auto cut = [&](const mpq_class& start, const mpq_class& step) {
    if (sgn(step) == 0) return sgn(start) >= 0;
    const mpq_class t = -start / step;
    if (sgn(step) > 0 ? (!first || *first < t) : (!last || *last > t)) (sgn(step) > 0 ? first : last) = t;
    return true;
  };
  const Frame& frame = view.frame();
  const bool meets =
      cut(mpq_class(from.x + margin), dx) && cut(mpq_class(frame.width + margin - from.x), mpq_class(-dx)) &&
      cut(mpq_class(from.y + margin), dy) && cut(mpq_class(frame.height + margin - from.y), mpq_class(-dy));
  if (!meets || !first || !last || *first > *last) return {};
  const auto at = [&](const mpq_class& t) {
    return Pixel{clamped(mpq_class(from.x + t * dx)), clamped(mpq_class(from.y + t * dy))};
  };
  return {at(*first), at(*last)};
}

std::string about(const mpq_class& value, std::size_t most) {
  if (sgn(value) == 0) return "0";
  mp_exp_t exponent = 0;
  std::string digits = mpf_class(value, 192).get_str(exponent, 10, most);
  const std::string sign = digits[0] == '-' ? "-" : "";
  digits.erase(0, sign.size());
  const std::int64_t power = static_cast<std::int64_t>(exponent) - 1;
  if (power < -4 || power > 5)
    return fmt::format("{}{}{}{}e{}", sign, digits[0], digits.size() > 1 ? "." : "", digits.substr(1), power);
  if (power < 0) return sign + "0." + std::string(static_cast<std::size_t>(-power - 1), '0') + digits;
  const std::size_t whole = static_cast<std::size_t>(power) + 1;
  if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0');
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

}  // namespace touchstone::report
