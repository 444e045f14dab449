// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/arc_tangent.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/integers/sine_cosine.h"

namespace touchstone::robust::kernel {
namespace {

using Bits = std::uint64_t;

std::int64_t size(const mpz_class& n) {
  return sgn(n) == 0 ? 0 : static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2));
}

/// n / 2^shift truncated towards zero: a double with at most 60 binary digits before the point.
double shortened(const mpz_class& n, std::int64_t shift) {
  mpz_class cut;
  mpz_tdiv_q_2exp(cut.get_mpz_t(), n.get_mpz_t(), static_cast<Bits>(std::max<std::int64_t>(shift, 0)));
  return cut.get_d();
}

/// An approximation of the angle, in (-pi, pi]; exactly 0 if the vector is within 2^-50 of +x.
double guess(const mpz_class& x, const mpz_class& y) {
  const ControlWord ieee;
  const std::int64_t shift = std::max(size(x), size(y)) - 60;
  const double along = shortened(x, shift), across = shortened(y, shift);
  if (along > 0 && std::fabs(across) < along * 0x1p-50) return 0;
  return std::atan2(across, along);
}

struct Turned {
  mpz_class angle, error;  ///< in units of 2^-bits
};

/// The angle of (x, y) beyond `start`, if its tangent is at most 0.4.
///
/// Turned back by `start` the vector is (x c + y s, y c - x s), each off by at most |x| + |y| times the error e of the
/// cosine c and sine s. The first of the two is at least 0.92 |(x, y)| > 0.65 (|x| + |y|), so their quotient, the
/// slope, is off by less than 1.4 / 0.65 e and terms of e^2: less than 3 e, and 1 for the cut. The arc tangent is
/// nowhere steeper than 1. Its series: power k + 2 is power k times the square of the slope, both cut, so from less
/// than 0.41 on a power is off by less than 2, a term by less than 3; what is left out after a power of 0 is less than
/// that.
std::optional<Turned> beyond(double start, const mpz_class& x, const mpz_class& y, Bits bits) {
  const SineCosine at = sine_cosine(start, bits);
  const mpz_class along = x * at.cosine + y * at.sine, across = y * at.cosine - x * at.sine;
  if (sgn(along) <= 0 || 5 * abs(across) > 2 * along) return std::nullopt;
  mpz_class slope = across << bits, square, power, term;
  slope /= along;
  square = slope * slope >> bits;
  Turned result{0, 3 * at.error + 8};
  power = slope;
  for (Bits k = 1; sgn(power) != 0; k += 2) {
    term = power / k;
    if (k % 4 == 1) result.angle += term;
    else result.angle -= term;
    power = power * square;
    mpz_tdiv_q_2exp(power.get_mpz_t(), power.get_mpz_t(), bits);
    result.error += 3;
  }
  return result;
}

/// start in units of 2^-bits, cut below.
mpz_class fixed(double start, Bits bits) {
  const Decoded part = decode(start);
  const std::int64_t shift = part.exponent + static_cast<std::int64_t>(bits);
  mpz_class n = scaled(Decoded{part.magnitude, 0, part.negative}, 0);
  if (shift >= 0) return n << static_cast<Bits>(shift);
  return n >> static_cast<Bits>(-shift);
}

}  // namespace

double angle_rounded(const mpz_class& x, const mpz_class& y) {
  const double guessed = guess(x, y);
  // The binary expansion of so small an angle has leading zeros, which give no precision; below 2^-1075 there is
  // nothing else.
  const std::int64_t zeros = guessed == 0 ? std::clamp<std::int64_t>(size(x) - size(y), 0, 1100) : 0;
  for (Bits bits = 192 + static_cast<Bits>(zeros);; bits *= 2) {
    double start = guessed;
    std::optional<Turned> rest = beyond(start, x, y, bits);
    // Never needed if the library has an arc tangent: the multiples of 1/2 are near every direction.
    for (start = rest ? start : -3; !rest; start += rest ? 0 : 0.5) rest = beyond(start, x, y, bits);
    mpz_class angle = rest->angle + fixed(start, bits);
    // Found up to full turns, less than 3.6 from 0.
    const mpz_class one = mpz_class(1) << bits, least = sgn(y) < 0 ? one : mpz_class(-one);
    if (angle < least) angle += pi(bits + 1);
    const mpz_class error = rest->error + 2;  // `start` and 2 pi cut
    mpz_class low = angle - error, high = angle + error;
    if (sgn(y) > 0 && sgn(low) < 0) low = 0;  // the angle is positive
    const double below = round_scaled(low, -static_cast<std::int64_t>(bits)),
                 above = round_scaled(high, -static_cast<std::int64_t>(bits));
    if (std::bit_cast<std::uint64_t>(below) == std::bit_cast<std::uint64_t>(above)) return below;
  }
}

}  // namespace touchstone::robust::kernel
