// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/sine_cosine.h"

#include <algorithm>

#include "robust/kernel/integers/integers.h"

namespace touchstone::robust::kernel {
namespace {

using Bits = std::uint64_t;

/// atan(1 / q) * 2^bits by its alternating series. Every power and every term is truncated once, so the sum is off by
/// less than two units a term, and by the first term left out, which is 0.
mpz_class inverse_tangent(std::uint64_t q, Bits bits) {
  mpz_class power = (mpz_class(1) << bits) / q, sum = 0, term;
  for (std::uint64_t k = 0; sgn(power) != 0; ++k) {
    term = power / (2 * k + 1);
    if (k % 2 == 0) sum += term;
    else sum -= term;
    power /= q * q;
  }
  return sum;
}

/// pi * 2^bits by Machin's formula, pi / 4 = 4 atan(1/5) - atan(1/239), off by less than 2.
mpz_class machin(Bits bits) {
  // With b = bits + guard the series have at most b / 4.6 + 1 and b / 15.8 + 1 terms, so they are off by less than 16 *
  // 2 * (b / 4.6 + 1) + 4 * 2 * (b / 15.8 + 1) < 8 b + 40 units, far below 2^guard; the last truncation costs less than
  // 1 more.
  const Bits guard = 48;
  mpz_class sum = 16 * inverse_tangent(5, bits + guard) - 4 * inverse_tangent(239, bits + guard);
  return sum >> guard;
}

/// u * 2^bits, truncated towards zero.
mpz_class fixed_point(const Decoded& u, Bits bits) {
  const std::int64_t shift = u.exponent + static_cast<std::int64_t>(bits);
  if (shift >= 0) return scaled(u, static_cast<int>(shift));
  const mpz_class n = scaled(u, 0);
  mpz_class cut;
  mpz_tdiv_q_2exp(cut.get_mpz_t(), n.get_mpz_t(), static_cast<std::uint64_t>(-shift));
  return cut;
}

/// (a * b) / 2^bits, rounded down: off by less than 1.
mpz_class product(const mpz_class& a, const mpz_class& b, Bits bits) {
  mpz_class p = a * b;
  p >>= bits;
  return p;
}

}  // namespace

mpz_class pi(Bits bits) {
  thread_local mpz_class digits;
  thread_local Bits known = 0;
  if (known < bits + 3) {
    known = std::max<Bits>(bits + 3, 1280);
    digits = machin(known);
  }
  // `digits` is off by less than 2, at least three places below the last; rounding at the last costs half at most.
  const Bits drop = known - bits;
  mpz_class rounded = (digits + (mpz_class(1) << (drop - 1))) >> drop;
  return rounded;
}

SineCosine sine_cosine(double u, Bits bits) {
  const Decoded part = decode(u);
  // |u| < 2^whole. The number of quarter turns in u is below 2^whole too, and multiplies the error of pi by as much.
  const Bits whole = static_cast<Bits>(std::max(0, part.exponent + 53)) + 2;
  const Bits fine = bits + whole;
  mpz_class angle = fixed_point(part, fine);
  const mpz_class half_pi = pi(fine + 1) >> 2;
  mpz_class turns, quarter = half_pi >> 1;
  mpz_fdiv_q(turns.get_mpz_t(), mpz_class(angle + quarter).get_mpz_t(), half_pi.get_mpz_t());
  angle -= turns * half_pi;
  angle >>= whole;
  // Here -0.8 < angle < 0.8 and its error is below 4 units of 2^-bits: 2 (half_pi off by less than 2, times the turns)
  // + 1 + 1.

  // Term k + 1 of either series is term k times square / ((n + 1)(n + 2)). With |square| < 0.64 * 2^bits, off by less
  // than 0.8 * 2 * 4 + 1 < 8 units, and |term| < 2^bits, a term off by e gives a next term off by less than (0.64 e + 8
  // + 1) / 2 + 1, which stays below 16 from e <= 16 on. So n terms are off by less than 16 n units. The terms left out
  // after a zero term (below one unit) shrink by a third each: 16 units cover it.
  const mpz_class square = product(angle, angle, bits);
  mpz_class cosine = mpz_class(1) << bits, sine = angle, term = cosine;
  std::uint64_t terms = 2;
  for (std::uint64_t n = 0; sgn(term) != 0; n += 2, ++terms) {
    term = -product(term, square, bits) / ((n + 1) * (n + 2));
    cosine += term;
  }
  term = angle;
  for (std::uint64_t n = 1; sgn(term) != 0; n += 2, ++terms) {
    term = -product(term, square, bits) / ((n + 1) * (n + 2));
    sine += term;
  }
  const mpz_class error = 16 * (terms + 2);
  const std::uint64_t quadrant = mpz_fdiv_ui(turns.get_mpz_t(), 4);
  if (quadrant % 2 == 1) {
    std::swap(sine, cosine);
    cosine = -cosine;
  }
  if (quadrant >= 2) {
    sine = -sine;
    cosine = -cosine;
  }
  return {sine, cosine, error, bits};
}

}  // namespace touchstone::robust::kernel
