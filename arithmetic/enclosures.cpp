// SPDX-License-Identifier: Apache-2.0
#include "arithmetic/enclosures.h"

#include <algorithm>
#include <cmath>

// Every shift, quotient and root here is off by less than 1 in the last place, and all that follows from it is counted
// in such places: "off by e" means |computed - meant| <= e 2^-fine.
namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {
namespace {

std::uint64_t places(std::int64_t n) { return static_cast<std::uint64_t>(n); }

/// atan(1/q) = 1/q - 1/(3 q^3) + ..., off by 2 for each of its terms and for the rest.
Integer arc_tangent_of_inverse(std::int64_t q, std::int64_t fine) {
  Integer power = (Integer(1) << places(fine)) / Integer(q), sum;
  const Integer square(q * q);
  for (std::int64_t k = 1; !power.is_zero(); k += 2, power /= square) {
    if ((k & 2) != 0) sum -= power / Integer(k);
    else sum += power / Integer(k);
  }
  return sum;
}

}  // namespace

/// J. Machin (1706): pi = 16 atan(1/5) - 4 atan(1/239). With 32 more bits the sums are off by far less than 1, and
/// cutting them adds 1; so does taking fewer bits of what is known.
Near pi(std::int64_t bits) {
  static thread_local Integer known;
  static thread_local std::int64_t known_bits = -1;
  if (bits > known_bits) {
    known_bits = bits + bits / 8 + 64;
    const std::int64_t fine = known_bits + 32;
    known = (Integer(16) * arc_tangent_of_inverse(5, fine) - Integer(4) * arc_tangent_of_inverse(239, fine)) >> 32;
  }
  return {known >> places(known_bits - bits), 3};
}

/// Taylor's series after multiples of a quarter turn are taken off, so that the rest r has |r| < 0.8.
std::array<Near, 2> sine_cosine(const Integer& digits, std::int64_t exponent, std::int64_t bits) {
  const std::int64_t fine = bits + 32;
  const std::int64_t size = std::max<std::int64_t>(static_cast<std::int64_t>(digits.bit_length()) + exponent, 0);
  Integer angle = digits;  // |angle| < 2^size; off by 1
  if (exponent + fine >= 0) angle <<= places(exponent + fine);
  else angle >>= places(-exponent - fine);
  // Fewer than 2^size quarters, each known with size + 31 places more, are off by 2^-30 together.
  const std::uint64_t more = places(size + 31);
  const Integer quarter = pi(fine + size + 31).n >> 1, scaled = angle << more, twice = scaled + scaled;
  const Integer turns = (angle.sign() < 0 ? twice - quarter : twice + quarter) / (quarter + quarter);
  angle = (scaled - turns * quarter) >> more;  // off by less than 3
  const Integer square = (angle * angle) >> places(fine);
  // A term is a product with a number below 1 that is off by 1, cut, divided by 2 at least, cut: off by 2 if the term
  // before was. The rest of the series when a term is 0 is less than 3. An angle off by 3 moves both results by 3.
  Integer cosine = Integer(1) << places(fine), sine = angle, term = cosine;
  std::int64_t terms = 2;
  for (std::int64_t k = 1; !term.is_zero(); k += 2, ++terms) {
    term = -((term * square) >> places(fine)) / Integer(k * (k + 1));
    cosine += term;
  }
  term = angle;
  for (std::int64_t k = 2; !term.is_zero(); k += 2, ++terms) {
    term = -((term * square) >> places(fine)) / Integer(k * (k + 1));
    sine += term;
  }
  const Integer error = (Integer(2 * terms + 8) >> 32) + Integer(2);
  sine >>= 32, cosine >>= 32;
  const bool swapped = turns.odd();
  const std::uint64_t turn = (turns & 3u).bits64();
  Near up{swapped ? cosine : sine, error}, along{swapped ? sine : cosine, error};
  if (turn >= 2) up.n.negate();
  if (turn == 1 || turn == 2) along.n.negate();
  return {std::move(up), std::move(along)};
}

/// Halves the angle by tan(u / 2) = t / (1 + sqrt(1 + t^2)) until the series t - t^3 / 3 + ... is short.
Near arc_tangent(const Integer& y, const Integer& x, std::int64_t bits) {
  const Integer up = abs(y), along = abs(x);
  const bool steep = up > along;
  // As many halvings as terms, about: each saves bits / halvings^2 of those.
  const std::int64_t halvings = 8 + static_cast<std::int64_t>(std::sqrt(static_cast<double>(bits)) / 3);
  const std::int64_t fine = bits + halvings + 40;
  const Integer one = Integer(1) << places(fine);
  Integer t = ((steep ? along : up) << places(fine)) / (steep ? up : along);  // off by 1
  std::int64_t done = 0;
  for (; done<halvings&& static_cast<std::int64_t>(t.bit_length())> fine - halvings; ++done)
    t = (t << places(fine)) /
        (one + sqrt((one << places(fine)) + t * t));  // off by 3: half of it remains, and 1.5 comes
  const Integer square = (t * t) >> places(fine);
  Integer sum = t, power = t;
  for (std::int64_t k = 3; !power.is_zero(); k += 2) {
    power = (power * square) >> places(fine);
    if ((k & 2) != 0) sum -= power / Integer(k);
    else sum += power / Integer(k);
  }
  // All of this is doubled `done` times, which is less than 2^-20 of the places that are kept as long as there are
  // fewer than 2^18 terms. So 1 for cutting, and for pi and its half at most 3 and 3.
  Integer angle = (sum << places(done)) >> places(fine - bits);
  if (steep) angle = (pi(bits).n >> 1) - angle;
  if (x.sign() < 0) angle = pi(bits).n - angle;
  if (y.sign() < 0) angle.negate();
  return {std::move(angle), 8};
}

/// The angle of (x, sqrt(1 - x^2)) on the unit circle: the root, off by 2^-bits, turns it by as much.
Near arc_cosine(const Integer& x, std::int64_t places_of_x, std::int64_t bits) {
  const Integer one = Integer(1) << places(places_of_x);
  Near near = arc_tangent(sqrt((one * one - x * x) << places(2 * bits)), x << places(bits), bits);
  ++near.error;
  return near;
}

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
