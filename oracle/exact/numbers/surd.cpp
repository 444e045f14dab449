// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/surd.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "oracle/exact/numbers/nearest_double.h"
#include "oracle/exact/numbers/nearest_float.h"

namespace touchstone::oracle {
namespace {

Rational square(const Rational& x) { return Rational(x * x); }

/// The sign of p + q sqrt(r), r >= 0.
int sign_of(const Rational& p, const Rational& q, const Integer& r) {
  const int of_p = sgn(p), of_root = sgn(q) * sgn(r);
  if (of_p * of_root >= 0) return of_p != 0 ? of_p : of_root;
  return of_p * sgn(Rational(square(p) - square(q) * r));
}

/// The sign of p + q sqrt(r) + s sqrt(u), r and u >= 0.
int sign_of(const Rational& p, const Rational& q, const Integer& r, const Rational& s, const Integer& u) {
  const int of_first = sign_of(p, q, r), of_second = sgn(s) * sgn(u);
  if (of_first * of_second >= 0) return of_first != 0 ? of_first : of_second;
  const Rational squares(square(p) + square(q) * r - square(s) * u), mixed(2 * p * q);
  return of_first * sign_of(squares, mixed, r);
}

/// number = root^2 rest
struct Split {
  Integer root, rest;
};

/// Takes squares out, as defined in the contract of Surd; number > 0.
Split split(Integer number) {
  Integer root(1), odd(1), prime, power;
  for (const std::uint64_t small : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47}) {
    prime = small;
    const mp_bitcnt_t times = mpz_remove(number.get_mpz_t(), number.get_mpz_t(), prime.get_mpz_t());
    mpz_ui_pow_ui(power.get_mpz_t(), small, times / 2);
    root *= power;
    if (times % 2 == 1) odd *= prime;
  }
  if (mpz_perfect_square_p(number.get_mpz_t()) != 0) {
    root *= sqrt(number);
    number = 1;
  }
  return {root, Integer(number * odd)};
}

/// The integer part of sqrt(number), number >= 0; checks it by squares.
Integer integer_root(const Integer& number) {
  const Integer root = sqrt(number);
  if (root * root > number || (root + 1) * (root + 1) <= number) throw std::logic_error("no root");
  return root;
}

/// The k with sqrt(b) = k sqrt(a), for integers above 0.
Rational multiple_of(const Integer& a, const Integer& b) {
  if (a == b) return Rational(1);
  const Integer product(a * b);
  if (mpz_perfect_square_p(product.get_mpz_t()) == 0) throw std::domain_error("surds of different radicands");
  Rational multiple(Integer(sqrt(product)), a);
  multiple.canonicalize();
  return multiple;
}

/// Two surds over one radicand: p + q sqrt(r), s + t sqrt(r); q or t may be 0.
struct Pair {
  const Rational &p, q, &s, t;
  const Integer& r;
};

Pair over_one_radicand(const Surd& a, const Surd& b) {
  if (a.rational() || b.rational()) {
    return {a.rational_part(), a.coefficient(), b.rational_part(), b.coefficient(),
            a.rational() ? b.radicand() : a.radicand()};
  }
  return {a.rational_part(), a.coefficient(), b.rational_part(),
          Rational(b.coefficient() * multiple_of(a.radicand(), b.radicand())), a.radicand()};
}

}  // namespace

Surd::Surd(const Rational& p, const Rational& q, const Rational& r) : rational_part_(p) {
  if (sgn(r) < 0) throw std::domain_error("the root of a negative number");
  const Rational rest(square(q) * r);
  if (sgn(rest) == 0) return;
  const Split above = split(rest.get_num()), below = split(rest.get_den());
  Rational coefficient(above.root, Integer(below.root * below.rest));
  coefficient.canonicalize();
  if (sgn(q) < 0) mpq_neg(coefficient.get_mpq_t(), coefficient.get_mpq_t());
  const Integer radicand(above.rest * below.rest);
  if (radicand == 1) {
    rational_part_ += coefficient;
  } else {
    root_ = std::make_shared<const Root>(Root{coefficient, radicand});
  }
}

const Rational& Surd::coefficient() const {
  static const Rational none(0);
  return rational() ? none : root_->coefficient;
}

const Integer& Surd::radicand() const {
  static const Integer none(0);
  return rational() ? none : root_->radicand;
}

RationalInterval Surd::enclosure(std::int64_t bits) const {
  if (rational()) return {rational_part_, rational_part_};
  // |q| sqrt(r) = sqrt(m^2 r) / d, and d >= 2^(its digits - 1).
  const Integer &m = root_->coefficient.get_num(), &d = root_->coefficient.get_den();
  const std::int64_t shift = bits - static_cast<std::int64_t>(mpz_sizeinbase(d.get_mpz_t(), 2)) + 1;
  Integer number(m * m * root_->radicand);
  if (shift >= 0) number <<= static_cast<mp_bitcnt_t>(2 * shift);
  else number >>= static_cast<mp_bitcnt_t>(-2 * shift);
  const Integer root = integer_root(number);
  const auto end = [&](const Integer& integer) {
    return Rational(scaled(integer, static_cast<int>(-shift)) / Rational(d));
  };
  const Rational low = end(root), high = end(Integer(root + 1));
  if (sgn(m) > 0) return {Rational(rational_part_ + low), Rational(rational_part_ + high)};
  return {Rational(rational_part_ - high), Rational(rational_part_ - low)};
}

std::string Surd::text() const {
  if (rational()) return rational_part_.get_str();
  std::string result = sgn(rational_part_) == 0 ? "" : rational_part_.get_str();
  const Rational size(abs(root_->coefficient));
  if (sgn(root_->coefficient) < 0) result += '-';
  else if (!result.empty()) result += '+';
  if (size != 1) result += size.get_str() + "*";
  return result + "sqrt(" + root_->radicand.get_str() + ")";
}

Surd operator-(const Surd& a) {
  if (a.rational()) return Surd(Rational(-a.rational_part_));
  return Surd(Rational(-a.rational_part_), Rational(-a.coefficient()), Rational(a.radicand()));
}

Surd operator+(const Surd& a, const Surd& b) {
  if (a.rational() && b.rational()) return Surd(Rational(a.rational_part_ + b.rational_part_));
  const Pair n = over_one_radicand(a, b);
  return Surd(Rational(n.p + n.s), Rational(n.q + n.t), Rational(n.r));
}

Surd operator-(const Surd& a, const Surd& b) {
  if (a.rational() && b.rational()) return Surd(Rational(a.rational_part_ - b.rational_part_));
  const Pair n = over_one_radicand(a, b);
  return Surd(Rational(n.p - n.s), Rational(n.q - n.t), Rational(n.r));
}

Surd operator*(const Surd& a, const Surd& b) {
  if (a.rational() && b.rational()) return Surd(Rational(a.rational_part_ * b.rational_part_));
  const Pair n = over_one_radicand(a, b);
  return Surd(Rational(n.p * n.s + n.q * n.t * n.r), Rational(n.p * n.t + n.q * n.s), Rational(n.r));
}

Surd operator/(const Surd& a, const Surd& b) {
  if (sgn(b) == 0) throw std::domain_error("division by zero");
  if (a.rational() && b.rational()) return Surd(Rational(a.rational_part_ / b.rational_part_));
  const Pair n = over_one_radicand(a, b);
  const Rational norm(square(n.s) - square(n.t) * n.r);  // not 0: sqrt(r) is irrational
  return Surd(Rational((n.p * n.s - n.q * n.t * n.r) / norm), Rational((n.q * n.s - n.p * n.t) / norm), Rational(n.r));
}

Surd sqrt(const Surd& a) {
  if (!a.rational()) throw std::domain_error("the root of an irrational number");
  return Surd(Rational(0), Rational(1), a.rational_part_);
}

int sgn(const Surd& a) {
  if (a.rational()) return sgn(a.rational_part_);
  return sign_of(a.rational_part_, a.coefficient(), a.radicand());
}

std::strong_ordering operator<=>(const Surd& a, const Surd& b) {
  if (a.rational() && b.rational()) return cmp(a.rational_part_, b.rational_part_) <=> 0;
  return sign_of(Rational(a.rational_part_ - b.rational_part_), a.coefficient(), a.radicand(),
                 Rational(-b.coefficient()), b.radicand()) <=> 0;
}

bool operator==(const Surd& a, const Surd& b) {
  return a.rational_part_ == b.rational_part_ && a.coefficient() == b.coefficient() && a.radicand() == b.radicand();
}

namespace {

[[noreturn]] void malformed(const std::string& text) { throw std::invalid_argument("not an exact number: " + text); }

Integer digits(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos) malformed(text);
  return Integer(text, 10);
}

Rational fraction(const std::string& text) {
  const auto bar = text.find('/');
  const Integer below = bar == std::string::npos ? Integer(1) : digits(text.substr(bar + 1));
  if (sgn(below) == 0) malformed(text);
  Rational value(digits(text.substr(0, bar)), below);
  value.canonicalize();
  return value;
}

Rational signed_fraction(const std::string& text) {
  return text.starts_with('-') ? Rational(-fraction(text.substr(1))) : fraction(text);
}

template <class Float, class Bits>
Float nearest(const Surd& value, Float (*round)(const Rational&)) {
  if (value.rational()) return round(value.rational_part());
  // |value| < 2^(top + 1)
  const std::int64_t of_root = binary_order(Rational(square(value.coefficient()) * value.radicand())) / 2 + 1;
  const std::int64_t of_rational = sgn(value.rational_part()) == 0 ? of_root : binary_order(value.rational_part()) + 1;
  for (std::int64_t bits = 64 - std::max(of_root, of_rational), more = 64;; bits += more, more *= 2) {
    const auto [low, high] = value.enclosure(bits);
    const Float result = round(low);
    if (std::bit_cast<Bits>(result) == std::bit_cast<Bits>(round(high))) return result;
  }
}

}  // namespace

Surd surd_of(const std::string& text) {
  const auto root = text.find("sqrt(");
  if (root == std::string::npos) return Surd(signed_fraction(text));
  if (!text.ends_with(')')) malformed(text);
  const Integer radicand = digits(text.substr(root + 5, text.size() - root - 6));
  std::string before = text.substr(0, root), size;
  const auto sign = before.find_last_of("+-");
  const bool has_sign = sign != std::string::npos;
  size = has_sign ? before.substr(sign + 1) : before;
  Rational coefficient(1), part(0);
  if (!size.empty()) {
    if (!size.ends_with('*')) malformed(text);
    coefficient = fraction(size.substr(0, size.size() - 1));
  }
  if (has_sign && before[sign] == '-') coefficient = -coefficient;
  if (has_sign && sign > 0) part = signed_fraction(before.substr(0, sign));
  if (has_sign && sign == 0 && before[0] == '+') malformed(text);
  return Surd(part, coefficient, Rational(radicand));
}

double nearest_double(const Surd& value) {
  return nearest<double, std::uint64_t>(value, static_cast<double (*)(const Rational&)>(nearest_double));
}
float nearest_float(const Surd& value) {
  return nearest<float, std::uint32_t>(value, static_cast<float (*)(const Rational&)>(nearest_float));
}

}  // namespace touchstone::oracle
