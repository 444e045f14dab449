// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_surd.h"

#include <optional>

namespace touchstone::certify {
namespace {

std::optional<mpz_class> digits(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  return mpz_class(text, 10);
}

/// digits ["/" digits], the second not 0
std::optional<Rational> fraction(const std::string& text) {
  const auto bar = text.find('/');
  const auto above = digits(text.substr(0, bar));
  const auto below = bar == std::string::npos ? mpz_class(1) : digits(text.substr(bar + 1));
  if (!above || !below || sgn(*below) == 0) return std::nullopt;
  Rational value(*above, *below);
  value.canonicalize();
  return value;
}

std::optional<Rational> signed_fraction(const std::string& text) {
  if (!text.starts_with('-')) return fraction(text);
  const auto size = fraction(text.substr(1));
  return size ? std::optional<Rational>(-*size) : std::nullopt;
}

/// [rational sign | "-"] [fraction "*"] "sqrt(" digits ")"
std::optional<Surd> rooted(const std::string& text, std::size_t root) {
  const auto radicand = text.ends_with(')') ? digits(text.substr(root + 5, text.size() - root - 6)) : std::nullopt;
  const std::string before = text.substr(0, root);
  const auto sign = before.find_last_of("+-");
  const bool has_sign = sign != std::string::npos;
  const std::string size = has_sign ? before.substr(sign + 1) : before;
  std::optional<Rational> part(0), coefficient(1);
  if (!size.empty()) coefficient = size.ends_with('*') ? fraction(size.substr(0, size.size() - 1)) : std::nullopt;
  if (has_sign && sign > 0) part = signed_fraction(before.substr(0, sign));
  if (!radicand || !part || !coefficient || (has_sign && sign == 0 && before[0] == '+')) return std::nullopt;
  const bool negative = has_sign && before[sign] == '-';
  return Surd{*part, negative ? Rational(-*coefficient) : *coefficient, Rational(*radicand)};
}

}  // namespace

int sign(const Surd& x) {
  const int of_p = sgn(x.p), of_root = sgn(x.q) * sgn(x.r);
  if (of_p * of_root >= 0) return of_p != 0 ? of_p : of_root;
  return of_p * sgn(Rational(x.p * x.p - x.q * x.q * x.r));
}

int compare(const Surd& x, const Surd& y) {
  const Surd left = x + Rational(-y.p);
  const int of_left = sign(left), of_root = sgn(y.q) * sgn(y.r);
  if (of_left != of_root) return of_left > of_root ? 1 : -1;
  return of_left * sign(square(left) + Rational(-y.q * y.q * y.r));
}

void expect_kind_of_root(const Claim& claim, bool rational) {
  claim.expect_kind(rational ? "root" : "irrational_root");
}

Surd operator+(const Surd& x, const Rational& y) { return {Rational(x.p + y), x.q, x.r}; }
Surd operator*(const Surd& x, const Rational& y) { return {Rational(x.p * y), Rational(x.q * y), x.r}; }
Surd square(const Surd& x) { return {Rational(x.p * x.p + x.q * x.q * x.r), Rational(2 * x.p * x.q), x.r}; }
Surd sum_over_one_root(const Surd& x, const Surd& y) { return {Rational(x.p + y.p), Rational(x.q + y.q), x.r}; }

bool Quadratic::proved_positive(const std::string& kind, bool ends) const {
  if (sgn(constant) <= 0) return false;
  if (kind == "receding") return sgn(linear) >= 0;
  if (kind == "too_late") {
    return ends && sgn(Rational(constant + linear + square)) > 0 && sgn(Rational(2 * square + linear)) <= 0;
  }
  expect(kind == "no_root", wrong_kind);
  return sgn(Rational(4 * square * constant - linear * linear)) > 0;
}

Surd exact_surd(const json& value, const std::string& what) {
  std::optional<Surd> result;
  if (value.is_string()) {
    const std::string text = value.get<std::string>();
    expect_not_too_long(text, what);
    const auto root = text.find("sqrt(");
    if (root != std::string::npos) {
      result = rooted(text, root);
    } else if (const auto rational = signed_fraction(text)) {
      result = Surd{*rational, 0, 0};
    }
  }
  expect(result.has_value(), what + ": an exact value \"p/q\" or \"p+q*sqrt(r)\"");
  return *result;
}

void expect_distance(const Claim& claim, const Rational& square) {
  expect(exact_value(claim.truth["squared_distance"], "truth.squared_distance") == square,
         "truth: squared_distance is wrong");
  const Surd distance = exact_surd(claim.truth["distance"], "truth.distance");
  expect(sign(distance) >= 0 && sign(certify::square(distance) + Rational(-square)) == 0, "truth: distance is wrong");
  expect_kind_of_root(claim, is_square(square));
}

}  // namespace touchstone::certify
