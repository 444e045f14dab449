// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/thin_shapes.h"
#include "robust/kernel/float_format.h"

/// The first stage: signs of polynomials, certain or unknown, from a few floating-point operations and a bound on their
/// error.
///
/// Every filter is a straight line: differences of the input, the polynomial, the maxima that bound its terms, a guard
/// on those maxima, one comparison. It is a template on the number type, and all its constants follow from that type's
/// FloatFormat, so that a toy format can be tried on all of its numbers.
///
/// Model. u = 2^(1 - precision), n = 2^min_exponent. The result of one operation on x and y is exact * (1 + e) + h with
/// |e| <= u. That holds to nearest, upwards, downwards and towards zero (to nearest alone it would hold with u/2), and
/// a compiler that contracts a * b + c to FMA only leaves roundings out. h is what underflow costs: a result flushed to
/// zero (FTZ) is off by less than n, an operand read as zero (DAZ) by less than n before it is added, and by less than
/// n times the other factor before it is multiplied. Gradual underflow costs less. The guards keep out overflow, and
/// NaN and infinity: a comparison with NaN is false, and false is "unknown". A guard e1 + e2 <= H bounds both, because
/// rounding is monotone and H is a number of the format.
///
/// What the derivations below share, for u <= 1/16:
/// (1) A difference d of two numbers of the input comes out as D with |D - d| <= u |d| + 4 n. Where |D| <= m that is at
///     most k m + 5 n, with k = u / (1 - u).
/// (2) Maxima are at most H, H >= 2. Then the absolute terms of a polynomial of second degree stay below 40 n H: it has
///     at most three products, whose factors cost 9.2 n H by (1) and 2.2 n H by DAZ and whose rounding costs n, and two
///     sums at 4 n. The computed bound C e1 e2 + A may lose 3 n H to underflow, and a factor (1 - u) for each of its
///     operations. A = 64 n H pays for all that.
/// (3) What is left is to choose C with (1 - u)^3 C >= T, where T is the sum of the relative terms. T / (1 - u)^3 is a
///     power series in u with positive coefficients, hence convex, so against a C = c u (1 + j u) with the same first
///     term it is enough to look at u = 1/16; every C below is a number of the format for double.
namespace touchstone::robust::filters {

enum class Sign { negative, unknown, positive };

/// The constants of one format.
template <class Float, class Format = FloatFormat<Float>>
struct Bounds {
  static_assert(Format::precision >= 5, "u <= 1/16 is used throughout");
  static_assert(Format::max_exponent >= 7, "the guards below need room");
  static constexpr double u = power_of_two(1 - Format::precision);

  /// H for polynomials of second degree (3 H^2 is finite) and for products of two of them (11 H^4 is finite). As thirds
  /// and sevenths of the range they leave about as much room below, where the absolute term hides everything, as above.
  static constexpr int high_exponent = Format::max_exponent / 3;
  static constexpr int high_exponent_of_products = Format::max_exponent / 7;

  static Float high() { return Format::above(power_of_two(high_exponent)); }
  static Float absolute() { return Format::above(power_of_two(6 + Format::min_exponent + high_exponent)); }
  static Float high_of_products() { return Format::above(power_of_two(high_exponent_of_products)); }
  /// 1024 n H^3
  static Float absolute_of_products() {
    return Format::above(power_of_two(10 + Format::min_exponent + 3 * high_exponent_of_products));
  }
};

template <class Float>
Float larger(const Float& a, const Float& b) {
  return a < b ? b : a;
}

/// The larger coordinate of a vector in magnitude.
template <class Float, class Format = FloatFormat<Float>>
Float extent(const Vector2<Float>& v) {
  return larger(Format::magnitude(v.x), Format::magnitude(v.y));
}

/// The sign of a computed value that is off by less than error.
template <class Float, class Format = FloatFormat<Float>>
Sign certain(const Float& value, const Float& error) {
  if (!(Format::magnitude(value) > error)) return Sign::unknown;
  return value > error ? Sign::positive : Sign::negative;
}

/// The sign of v.x * w.y - v.y * w.x, each coordinate a computed difference of two numbers of the input, or such a
/// number.
///
/// In units of extent(v) extent(w): a product of two differences is off by u (its rounding) + 2 k + k^2 (1), and at
/// most 1 + u; the subtraction rounds a number of at most 2 (1 + u). T = 2 (u + 2 k + k^2) + 2 u (1 + u) = 8 u + ...,
/// and C = 8 u (1 + 5 u): at u = 1/16, T / (8 u (1 - u)^3) = 1.295 < 1.3125.
template <class Float, class Format = FloatFormat<Float>>
Sign cross_sign(const Vector2<Float>& v, const Vector2<Float>& w) {
  using B = Bounds<Float, Format>;
  const Float value = v.x * w.y - v.y * w.x;
  const Float ev = extent<Float, Format>(v), ew = extent<Float, Format>(w);
  if (!(ev + ew <= B::high())) return Sign::unknown;
  return certain<Float, Format>(value, Format::above(8 * B::u * (1 + 5 * B::u)) * ev * ew + B::absolute());
}

/// Positive: p lies left of p0 -> p1; negative: right.
template <class Float, class Format = FloatFormat<Float>>
Sign orientation(const Point2<Float>& p0, const Point2<Float>& p1, const Point2<Float>& p) {
  return cross_sign<Float, Format>(p1 - p0, p - p0);
}

/// The sign of radius^2 - v.x^2 - v.y^2, v a computed difference of two points: positive inside the circle.
///
/// In units of the square of the largest of |v.x|, |v.y|, |radius|: the squares of v are off by u + 2 k + k^2 each, the
/// square of the radius by u; the sum rounds a number of at most 2 (1 + u), the difference one of at most 2 (1 + u)^2
/// (both are positive). T = 2 (u + 2 k + k^2) + u + 2 u (1 + u) + 2 u (1 + u)^2 = 11 u + ..., and C = 11 u (1 + 8 u):
/// at u = 1/16, T / (11 u (1 - u)^3) = 1.301 < 1.5.
template <class Float, class Format = FloatFormat<Float>>
Sign circle(const Vector2<Float>& v, const Float& radius) {
  using B = Bounds<Float, Format>;
  const Float value = radius * radius - (v.x * v.x + v.y * v.y);
  const Float scale = larger(extent<Float, Format>(v), Format::magnitude(radius));
  if (!(scale <= B::high())) return Sign::unknown;
  return certain<Float, Format>(value, Format::above(11 * B::u * (1 + 8 * B::u)) * scale * scale + B::absolute());
}

/// The sign of y - (slope * x + intercept): positive above the line.
///
/// In units of the largest of |slope * x|, |intercept|, |y|: the product is off by k, the sum rounds a number of at
/// most 2 + k, the difference one of at most 1 + (2 + k) (1 + u). (With FMA the product is exact instead, and at most 1
/// + k.) Underflow costs 2.2 n H for a factor read as zero, n for the product and 4 n for each sum; the bound has one
/// product less. T = k + u (2 + k) + u (1 + (2 + k) (1 + u)) = 6 u + ..., and C = 6 u (1 + 4 u): at u = 1/16, T / (6 u
/// (1 - u)^2) = 1.201 < 1.25.
template <class Float, class Format = FloatFormat<Float>>
Sign elevation(const Float& slope, const Float& intercept, const Point2<Float>& p) {
  using B = Bounds<Float, Format>;
  const Float product = slope * p.x;
  const Float value = p.y - (product + intercept);
  const Float scale = larger(Format::magnitude(product), larger(Format::magnitude(intercept), Format::magnitude(p.y)));
  const Float factor = larger(Format::magnitude(slope), Format::magnitude(p.x));
  if (!(scale + factor <= B::high())) return Sign::unknown;
  return certain<Float, Format>(value, Format::above(6 * B::u * (1 + 4 * B::u)) * scale + B::absolute());
}

/// The sign of the larger of two products, if both factors of that product have a certain sign. One factor is a
/// determinant d, computed as in `cross_sign` from coordinates of at most ex (every x) and ey (every y); the other is a
/// sum or difference e of two such determinants.
///
/// In units of M = ex ey: with T as in `cross_sign`, d is off by T and at most 2 (1 + u)^2; e is off by T2 =
/// 2 T + 4 u (1 + u)^2 and at most 4 (1 + u)^3. So a product one of whose factors has no certain sign is at most
/// 4 T (1 + u)^4 = 32 u + ... or 2 T2 (1 + u)^3 = 40 u + ..., in units of M^2. The computed bound loses a factor
/// (1 - u)^5 at most. B = 40 u (1 + 16 u): at u = 1/16 the two, divided by that factor, are 3.754 and 4.469 and B is 5.
/// The absolute terms, 40 n H in d and 90 n H in e, meet factors of at most 4.8 H^2: 1024 n H^3 pays for them.
template <class Float, class Format = FloatFormat<Float>>
Sign larger_product(const Float& p, const Float& q, const Float& ex, const Float& ey) {
  using B = Bounds<Float, Format>;
  if (!(ex + ey <= B::high_of_products())) return Sign::unknown;
  const Float scale = ex * ey;
  const Float bound = Format::above(40 * B::u * (1 + 16 * B::u)) * scale * scale + B::absolute_of_products();
  return certain<Float, Format>(larger(p, q), bound);
}

/// The largest magnitude of three.
template <class Float, class Format = FloatFormat<Float>>
Float extent(const Float& a, const Float& b, const Float& c) {
  return larger(larger(Format::magnitude(a), Format::magnitude(b)), Format::magnitude(c));
}

/// Whether two segments meet: negative: they cross; positive: a line of one has the other on one side.
///
/// They cross where the ends of each lie on different sides of the other's line: both products of sides are negative.
/// So the larger product decides, whatever its sign. Seen from b.a, the ends of a are f and f + r, and those of b are 0
/// and s; the sides are r x f and r x (f - s) = r x f - r x s, and s x f and s x (f + r) = s x f - r x s. A NaN or an
/// infinity in any coordinate gets into both products.
template <class Float, class Format = FloatFormat<Float>>
Sign segments(const Segment2<Float>& a, const Segment2<Float>& b) {
  const Vector2<Float> r = a.b - a.a, s = b.b - b.a, f = a.a - b.a;
  const Float rs = r.x * s.y - r.y * s.x, rf = r.x * f.y - r.y * f.x, sf = s.x * f.y - s.y * f.x;
  const Float ex = extent<Float, Format>(r.x, s.x, f.x), ey = extent<Float, Format>(r.y, s.y, f.y);
  return larger_product<Float, Format>(rf * (rf - rs), sf * (sf - rs), ex, ey);
}

/// Whether a line parallel to an axis lies strictly between two segments. Comparisons do not round; denormals-are-zero
/// can make them equal but never turn them round.
template <class Float>
bool apart(const Segment2<Float>& a, const Segment2<Float>& b) {
  const auto below = [](const Float& p, const Float& q, const Float& r, const Float& s) {
    return static_cast<int>(larger(p, q) < (r < s ? r : s));
  };
  // One branch in all: nobody can predict on which side.
  return (below(a.a.x, a.b.x, b.a.x, b.b.x) | below(b.a.x, b.b.x, a.a.x, a.b.x) | below(a.a.y, a.b.y, b.a.y, b.b.y) |
          below(b.a.y, b.b.y, a.a.y, a.b.y)) != 0;
}

/// Whether a ray and a segment meet: negative: they cross; positive: they do not.
///
/// Seen from the origin, with v the ray's direction, the segment's ends are f and f + s: on different sides of the
/// ray's line where (v x f) (v x (f + s)) < 0, v x (f + s) = v x f + v x s, and then t = (f x s) / (v x s) has the sign
/// of (f x s) (v x (f + s)). If that product is negative there is no common point even where the ends lie on one side.
/// So the larger of the first product and minus the second decides.
template <class Float, class Format = FloatFormat<Float>>
Sign ray(const Point2<Float>& origin, const Vector2<Float>& v, const Segment2<Float>& segment) {
  const Vector2<Float> f = segment.a - origin, s = segment.b - segment.a;
  const Float vf = v.x * f.y - v.y * f.x, vs = v.x * s.y - v.y * s.x, sf = s.x * f.y - s.y * f.x;
  const Float end = vf + vs;
  const Float ex = extent<Float, Format>(v.x, s.x, f.x), ey = extent<Float, Format>(v.y, s.y, f.y);
  return larger_product<Float, Format>(vf * end, sf * end, ex, ey);
}

}  // namespace touchstone::robust::filters
