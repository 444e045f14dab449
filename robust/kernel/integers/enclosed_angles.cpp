// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/enclosed_angles.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/integers/sine_cosine.h"

namespace touchstone::robust::kernel {
namespace {

constexpr int steps = 256;              // per radian
constexpr int last = 202;               // steps in an eighth of a turn, rounded up
constexpr double half_step = 0x1.1p-9;  // and a sixteenth more, because j and k come from rounded numbers
constexpr double u53 = 0x1p-53;
using Bits = std::uint64_t;
constexpr Bits digits = 192;

/// n / 2^digits, rounded.
double number(const mpz_class& n) { return round_scaled(n, -static_cast<std::int64_t>(digits)); }
/// The same number as an integer, truncated below 2^-digits.
mpz_class integer(double x) {
  const Decoded part = decode(x);
  const mpz_class n = scaled(Decoded{part.magnitude, 0, part.negative}, 0);
  const std::int64_t shift = part.exponent + static_cast<std::int64_t>(digits);
  return shift >= 0 ? mpz_class(n << static_cast<Bits>(shift)) : mpz_class(n >> static_cast<Bits>(-shift));
}
/// Off by u^2 of it, plus the error of n.
Pair<double> pair(const mpz_class& n) {
  const double high = number(n);
  return {high, number(n - integer(high))};
}

/// Tables that are computed once. sine_cosine and pi are off by less than 2^12 units of 2^-192.
struct Tables {
  std::array<Pair<double>, last + 1> sine, cosine;  ///< of j / 256
  std::array<Pair<double>, 5> quarters;             ///< multiples of pi / 2
  std::array<double, 3> quarter;                    ///< pi / 2 in parts of 29, 29 and 53 digits

  Tables() {
    for (int j = 0; j <= last; ++j) {
      const SineCosine at = sine_cosine(static_cast<double>(j) / steps, digits);
      const auto place = static_cast<std::size_t>(j);
      sine[place] = pair(at.sine), cosine[place] = pair(at.cosine);
    }
    const mpz_class half_pi = pi(digits) >> 1;
    for (std::size_t q = 0; q < quarters.size(); ++q) quarters[q] = pair(half_pi * static_cast<Bits>(q));
    mpz_class rest = half_pi;
    for (const Bits below : {digits - 28, digits - 57}) {
      const mpz_class part = rest >> below << below;
      quarter[below == digits - 28 ? 0 : 1] = number(part);
      rest -= part;
    }
    quarter[2] = number(rest);
  }
};

const Tables& tables() {
  static const Tables made;
  return made;
}

/// The nearest integer, |x| < 2^51: adding 3 2^51 leaves no room for further digits.
double nearest(double x) { return (x + 0x1.8p52) - 0x1.8p52; }

/// u minus the nearest multiple of pi / 2, which is q times it: within an eighth of a turn and a little.
///
/// q has at most 21 digits, so its products with the first two parts are exact. The third is off by u of it, and pi / 2
/// by less than 2^-110.9, which is less than u of the third part, above 2^-57.3.
struct Reduced {
  Enclosed<double> angle;
  int quadrant;
};
Reduced reduced(double u, const Tables& t) {
  const double q = nearest(u * 0x1.45f306dc9c883p-1);  // 2 / pi, about
  if (q == 0) return {{u, 0, 0}, 0};
  const auto exactly = [](double x) { return Enclosed<double>{x, 0, 0}; };
  const double rest = q * t.quarter[2];
  return {exactly(u) - exactly(q * t.quarter[0]) - exactly(q * t.quarter[1]) -
              Enclosed<double>{rest, 0, 2 * u53 * std::fabs(rest)},
          static_cast<int>(q) & 3};
}

}  // namespace

/// With a the angle of the table, and s the rest, |s| <= half_step:
///
///     cos(a + s) = cos a - sin a s + (cos a (cos s - 1) - sin a (sin s - s))
///     sin(a + s) = sin a + cos a s + (sin a (cos s - 1) + cos a (sin s - s))
///
/// The last part is computed in double, from s rounded. Its polynomials leave out s^8 / 8! and s^9 / 9!, less than u /
/// 8 of them. s^2 is off by 3 u, cos s - 1 by 3 u more and sin s - s by 5 u more, both for their coefficients and the
/// last steps; what they are multiplied with by u; these products and their sum by 2 u. Together 11 u; 14 are taken.
/// The pairs of the table are off by u^2, which the 7 E of a product hold.
std::optional<Enclosed<Two>> enclosed_cosine_sine(double u) {
  if (!(std::fabs(u) <= 0x1p20)) return std::nullopt;
  const Tables& t = tables();
  const Reduced r = reduced(u, t);
  const double j = nearest((r.angle.high + r.angle.low) * steps);
  const auto place = static_cast<std::size_t>(std::fabs(j));
  if (place > last) return std::nullopt;
  const Enclosed<double> left = r.angle + Enclosed<double>{-j / steps, 0, 0};
  if (!left.settled() || !(std::fabs(left.high) <= half_step)) return std::nullopt;

  // The unit vector of the table's angle, rotated by quarter turns.
  const double sign = j < 0 ? -1 : 1;
  Two high(t.cosine[place].high, sign * t.sine[place].high), low(t.cosine[place].low, sign * t.sine[place].low);
  const auto turned = [](Two v) { return Two(-v.second(), v.first()); };
  for (int i = 0; i < r.quadrant; ++i) high = turned(high), low = turned(low);
  const Two across_high = turned(high), across_low = turned(low);

  const Factor<double> part = factor(left);
  const double s = part.whole, s2 = s * s;
  const double cosine_less_1 = s2 * (-1.0 / 2 + s2 * (1.0 / 24 - s2 * (1.0 / 720)));
  const double sine_less_s = s * s2 * (-1.0 / 6 + s2 * (1.0 / 120 - s2 * (1.0 / 5040)));
  const Two of_cosine = high * Two(cosine_less_1), of_sine = across_high * Two(sine_less_s);

  const Factor<Two> twice{Two(part.whole), Two(part.head), Two(part.tail)};
  Sum<Two> sum(Term2<Two>{high, low});
  sum += product(twice, factor(Pair<Two>{across_high, across_low}));
  sum += of_cosine + of_sine;
  using Format = filters::FloatFormat<Two>;
  Enclosed<Two> result = sum.value();
  result.error = result.error + Two(1.25 * left.error) * Format::magnitude(across_high) +
                 Two(1.25 * 14 * u53) * (Format::magnitude(of_cosine) + Format::magnitude(of_sine));
  return result;
}

/// The vector is rotated by quarter turns until it is within an eighth of a turn of +x, then back by the nearby
/// multiple of 1/256. That choice needs no accuracy, since the rest corrects it. With w the remaining slope, |w| <=
/// half_step:
///
///     atan w = w + (-w^3 / 3 + w^5 / 5 - w^7 / 7)
///
/// The remainder of the series is u / 2 of its part in parentheses, which is computed in double from w rounded: w^2 is
/// off by 3 u, w^3 by 5 u, the polynomial by 3 u, their product by u: of 10 u, with that half, 14 are taken.
std::optional<Enclosed<double>> enclosed_angle(const Enclosed<double>& x, const Enclosed<double>& y) {
  if (!x.settled() || !y.settled() || x.high == 0 || y.high == 0) return std::nullopt;
  const Tables& t = tables();
  const bool steep = std::fabs(y.high) > std::fabs(x.high);
  // Rotated by this many quarter turns clockwise: (x, y), (y, -x), (-x, -y), (-y, x).
  std::size_t quarters = steep ? (y.high > 0 ? 1 : 3) : (x.high > 0 ? 0 : 2);
  const Enclosed<double> along_axis = quarters == 0 ? x : quarters == 1 ? y : quarters == 2 ? -x : -y;
  const Enclosed<double> across_axis = quarters == 0 ? y : quarters == 1 ? -x : quarters == 2 ? -y : x;
  const bool below = across_axis.high < 0;
  if (quarters == 0 && below) quarters = 4;

  const Enclosed<double> up = below ? -across_axis : across_axis;
  const auto place = static_cast<std::size_t>(nearest(std::atan(up.high / along_axis.high) * steps));
  if (place > last) return std::nullopt;
  Enclosed<double> rise = up, run = along_axis;
  if (place != 0) {
    const Enclosed<double> cosine{t.cosine[place].high, t.cosine[place].low, 0},
        sine{t.sine[place].high, t.sine[place].low, 0};
    rise = up * cosine - along_axis * sine, run = along_axis * cosine + up * sine;
  }
  if (!run.settled() || !(run.high > 0)) return std::nullopt;
  const Enclosed<double> slope = rise / Divisor(run);
  const double w = slope.high + slope.low, w2 = w * w;
  if (!(std::fabs(w) <= half_step)) return std::nullopt;
  const double bend = w * w2 * (-1.0 / 3 + w2 * (1.0 / 5 - w2 * (1.0 / 7)));

  const double sign = below ? -1 : 1;
  Sum<double> sum(Term2<double>{t.quarters[quarters].high, t.quarters[quarters].low});
  sum += sign * (static_cast<double>(place) / steps);
  sum += Term2<double>{sign * slope.high, sign * slope.low};
  sum += sign * bend;
  Enclosed<double> angle = sum.value();
  angle.error = angle.error + 1.25 * slope.error + 1.25 * 14 * u53 * std::fabs(bend);
  return angle;
}

}  // namespace touchstone::robust::kernel
