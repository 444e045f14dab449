// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robust/kernel/filters/float_format.h"

/// Numbers with one and a half times the precision, each with a bound on its error: the stage between filters, which
/// compute no number, and integers, which compute every number. If both ends of an enclosure round to the same double,
/// that is the correctly rounded number (the rounding test of libraries of correctly rounded functions, after Ziv).
///
/// Model. p = precision, u = 2^-p. Rounding is to nearest, so that one operation is exact * (1 + e), |e| <= u, and
/// nothing overflows or underflows: the caller checks both with robust/kernel/enclosed/window.h beforehand.
///
/// A number is split into a head of k = p / 2 digits (rounded down) and a tail below T = 2^(1 - k) of it. The product
/// of two heads has at most p digits: it is exact, the same whether a compiler contracts it with a sum or not, and all
/// rounding errors are in tails, where one costs u T = E of the number, 2^-78 for double. (Error-free products, by
/// Dekker's halves or FMA, would reach u^2 and take three times as long; error-free sums, which keep the tails of
/// cancelling terms, are needed in both.) If a compiler contracts a product in a tail, one rounding disappears.
///
/// Bounds. They are derived to first order in units of E; each constant leaves a sixth or more of itself for what that
/// neglects, factors 1 + T and 1 + u: proptests/infrastructure/robust/toy_enclosed.cpp tries formats with T up to 2^-5.
/// An `error` of another number is carried over times 5/4, which pays for the roundings in computing it too. For double
/// all of them are proved, with what they neglect (docs/proofs.md).
namespace touchstone::robust::kernel {

/// u and E of a format, as doubles.
template <class Float>
inline constexpr double half_ulp = filters::power_of_two(-filters::FloatFormat<Float>::precision);
template <class Float>
inline constexpr double cut = half_ulp<Float>* filters::power_of_two(1 - filters::FloatFormat<Float>::precision / 2);

/// high + low, exactly; high is that sum rounded, so |low| <= u |high|.
template <class Float>
struct Pair {
  Float high, low;
};

template <class Float>
Pair<Float> two_sum(const Float& a, const Float& b) {
  const Float sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

template <class Float>
Pair<Float> difference(const Float& a, const Float& b) {
  const Float sum = a - b, of_b = a - sum;
  return {sum, (a - (sum + of_b)) + (of_b - b)};
}

/// A number as head + tail, off by at most E |whole|; whole is the rounded number.
template <class Float>
struct Factor {
  Float whole, head, tail;
};

/// high - head is exact, and the tail at most (T + u) |high|: rounding it costs E.
template <class Float>
Factor<Float> factor(const Pair<Float>& x) {
  const Float head = filters::FloatFormat<Float>::head(x.high);
  return {x.high, head, (x.high - head) + x.low};
}
/// The conversion is exact.
template <class Float>
Factor<Float> factor(const Float& x) {
  const Float head = filters::FloatFormat<Float>::head(x);
  return {x, head, x - head};
}

/// One term of a sum: head + tail. The head has p digits.
template <class Float>
struct Term2 {
  Float head, tail;
  friend Term2 operator-(const Term2& t) { return {-t.head, -t.tail}; }
};

/// Either product in the tail is at most T of the head and costs E, their sum 2 E, both factors themselves E each, and
/// whole instead of head + tail E: together 7 E of the head. The tail is at most 2 T of it.
template <class Float>
Term2<Float> product(const Factor<Float>& x, const Factor<Float>& y) {
  return {x.head * y.head, x.head * y.tail + x.tail * y.whole};
}

/// A real number within error of high + low.
template <class Float>
struct Enclosed {
  Float high, low, error;

  /// True if the number is zero, or certainly nonzero with the sign of high; then low is small compared with high.
  bool settled() const {
    using Format = filters::FloatFormat<Float>;
    return Format::magnitude(high) >= Format::above(16) * (Format::magnitude(low) + error);
  }
};

/// A sum of less than 2^12 terms: heads by two_sum, and tails and what two_sum leaves in one number.
///
/// Let M be the sum of the magnitudes of n heads. The terms are off by 7 E M, and their tails are at most 2 T M. The
/// remainder of two_sum is at most u M each time; adding it to the term's tail costs 2 E M for all terms together,
/// adding both to what is left so far 2 E M for each but the first; for u M, n^2 u^2 M more. Together 2 n + 7 in units
/// of E M, and n^2 u / T, which is below 1/8. 2 n + 12 are taken.
template <class Float>
class Sum {
  using Format = filters::FloatFormat<Float>;

 public:
  explicit Sum(const Term2<Float>& first) : high_(first.head), low_(first.tail), size_(Format::magnitude(first.head)) {}

  Sum& operator+=(const Term2<Float>& term) {
    const Pair<Float> sum = two_sum(high_, term.head);
    high_ = sum.high;
    low_ = low_ + (sum.low + term.tail);
    size_ = size_ + Format::magnitude(term.head);
    terms_ += 1;
    return *this;
  }
  Sum& operator-=(const Term2<Float>& term) { return *this += -term; }
  Sum& operator+=(const Float& number) { return *this += Term2<Float>{number, Float()}; }

  Enclosed<Float> value() const { return {high_, low_, Format::above(cut<Float> * (2 * terms_ + 12)) * size_}; }

 private:
  Float high_, low_, size_;
  int terms_ = 1;
};

/// Adding the low parts and the errors of two_sum costs 2 u of their magnitudes; 3 are taken.
template <class Float>
Enclosed<Float> operator+(const Enclosed<Float>& x, const Enclosed<Float>& y) {
  using Format = filters::FloatFormat<Float>;
  const Pair<Float> sum = two_sum(x.high, y.high);
  const Float size = Format::magnitude(x.low) + Format::magnitude(y.low) + Format::magnitude(sum.low);
  return {sum.high, sum.low + (x.low + y.low),
          Format::above(1.25) * (x.error + y.error) + Format::above(3 * half_ulp<Float>) * size};
}
template <class Float>
Enclosed<Float> operator-(const Enclosed<Float>& x) {
  return {-x.high, -x.low, x.error};
}
template <class Float>
Enclosed<Float> operator-(const Enclosed<Float>& x, const Enclosed<Float>& y) {
  return x + -y;
}

/// For a settled number: low is at most high / 16, so head lies between high / 2 and 2 high, and high - head is exact
/// (Sterbenz).
template <class Float>
Factor<Float> factor(const Enclosed<Float>& x) {
  const Float whole = x.high + x.low, head = filters::FloatFormat<Float>::head(whole);
  return {whole, head, (x.high - head) + x.low};
}

/// For settled numbers. 7 E as in `product`, of which 10 are taken; the product of both errors is at most a sixteenth
/// of another term.
template <class Float>
Enclosed<Float> operator*(const Enclosed<Float>& x, const Enclosed<Float>& y) {
  using Format = filters::FloatFormat<Float>;
  const Factor<Float> left = factor(x), right = factor(y);
  const Term2<Float> term = product(left, right);
  const Float carried = Format::magnitude(left.whole) * y.error + Format::magnitude(right.whole) * x.error;
  return {term.head, term.tail,
          Format::above(1.25) * carried + Format::above(10 * cut<Float>) * Format::magnitude(term.head)};
}

/// high is the rounded number; off by no more than x.error. Adding 0 rounds a product that a compiler could contract.
template <class Float>
Pair<Float> in_order(const Enclosed<Float>& x) {
  return two_sum(x.high, x.low + Float());
}

/// For any two numbers: the bound is that of the product of settled numbers, plus the product of both errors, which is
/// not small here.
template <class Float>
Enclosed<Float> times(const Enclosed<Float>& x, const Enclosed<Float>& y) {
  using Format = filters::FloatFormat<Float>;
  const Factor<Float> left = factor(in_order(x)), right = factor(in_order(y));
  const Term2<Float> term = product(left, right);
  const Float carried =
      Format::magnitude(left.whole) * y.error + Format::magnitude(right.whole) * x.error + x.error * y.error;
  return {term.head, term.tail,
          Format::above(1.25) * carried + Format::above(10 * cut<Float>) * Format::magnitude(term.head)};
}

/// start + t v for a t with the error that Sum gives, and that error times |v|. t's tail is at most T of its head, or
/// beyond that by no more than the error.
template <class Float>
[[gnu::always_inline]] inline Enclosed<Float> along(const Float& start, const Factor<Float>& t, const Float& error,
                                                    const Factor<Float>& v) {
  using Format = filters::FloatFormat<Float>;
  Sum sum(product(t, v));
  sum += start;
  Enclosed<Float> result = sum.value();
  result.error = result.error + Format::above(1.25) * error * Format::magnitude(v.whole);
  return result;
}
/// For a quotient t, whose high part is its head.
template <class Float>
[[gnu::always_inline]] inline Enclosed<Float> along(const Float& start, const Enclosed<Float>& t,
                                                    const Factor<Float>& v) {
  return along(start, Factor<Float>{t.high, t.high, t.low}, t.error, v);
}

/// A settled number that is not zero, for several quotients by it.
template <class Float>
struct Divisor {
  Factor<Float> value;
  Float error, inverse;
  explicit Divisor(const Enclosed<Float>& d)
      : value(factor(d)), error(d.error), inverse(filters::FloatFormat<Float>::above(1) / value.whole) {}
};

/// high has k digits: the quotient's head, q.
///
/// q is off by T and 6 u; let S = |q d|. q times the divisor's head leaves at most 2 T S + |n.low| of n.high, which
/// costs 2 E S and u |n.low|, and nothing if n is settled (Sterbenz). q times the divisor's tail costs E S; its
/// subtraction, which leaves little more than T S + |n.low|, E S and u |n.low|; adding n.low, which leaves little more
/// than T S, E S; the divisor's tail itself is off by E. The remainder times the inverse, which is off by 3 u: 3 E S
/// and E S. Together 10 E of the quotient, and 2 u |n.low / d|; 14 E and 40 u |n.low| are taken.
///
/// For the errors: n / d is off by (n.error + |n / d| d.error) / (|d| - d.error), and d.error <= |d| / 16.
template <class Float>
Enclosed<Float> operator/(const Enclosed<Float>& n, const Divisor<Float>& d) {
  using Format = filters::FloatFormat<Float>;
  const Float q = Format::head((n.high + n.low) * d.inverse);
  const Float rest = ((n.high - q * d.value.head) - q * d.value.tail) + n.low;
  const Float size = Format::magnitude(q);
  const Float carried = n.error + size * d.error + Format::above(40 * half_ulp<Float>) * Format::magnitude(n.low);
  return {q, rest * d.inverse,
          Format::above(1.25) * carried * Format::magnitude(d.inverse) + Format::above(14 * cut<Float>) * size};
}

/// For a settled positive number. high has k digits: the root's head, r.
///
/// r^2 is exact, and so is its subtraction from high (Sterbenz). The remainder together with low, x - r^2, is at most 2
/// T x: rounding it costs 2 E x, E of the root. The root is r + (x - r^2) / (root + r). The sum of roots is off by 2 u,
/// its inverse by another, the product by another: 4 E of the root, as what is added is at most T of it. Together 5 E;
/// 8 are taken. As error <= x / 16, the root is off by error / (1.96 r) for it.
template <class Float>
Enclosed<Float> square_root(const Enclosed<Float>& x) {
  using Format = filters::FloatFormat<Float>;
  const Float root = Format::square_root(x.high + x.low), r = Format::head(root);
  const Float inverse = Format::above(1) / (root + r), rest = (x.high - r * r) + x.low;
  return {r, rest * inverse, Format::above(1.25) * x.error * inverse + Format::above(8 * cut<Float>) * r};
}

/// The nearest Float to the enclosed number, if every number of the enclosure rounds to the same Float. Zero is +0.
///
/// A halfway case is never answered: the ends lie on either side of it, so the direction of its rounding does not
/// matter.
///
/// The ends are rounded twice: before they are added to high, low + margin and low - margin are off by u (|low| +
/// margin), for which margin has 2 u |low| + error / 4 to spare.
template <class Float>
std::optional<Float> rounded(const Enclosed<Float>& x) {
  using Format = filters::FloatFormat<Float>;
  const Float margin = Format::above(1.25) * x.error + Format::above(2 * half_ulp<Float>) * Format::magnitude(x.low);
  const Float above = x.high + (x.low + margin), below = x.high + (x.low - margin);
  if (!(above <= below)) return std::nullopt;
  return above + Float();  // -0 + 0 is +0
}

}  // namespace touchstone::robust::kernel
