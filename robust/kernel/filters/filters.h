// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/thin_shapes.h"
#include "robust/kernel/filters/float_format.h"
#include "robust/kernel/filters/staged.h"

/// The first stage: signs of polynomials, certain or unknown, from a few floating-point operations and a bound on their
/// error.
///
/// Every filter is branch-free: differences of the input, the polynomial, sums of magnitudes that bound its terms, one
/// comparison with the bound and one guard on the sums. It contains no maximum and no other selection: if a compiler
/// makes a branch of it, half of the branches are mispredicted. It is a template on the number type, and all its
/// constants follow from that type's FloatFormat, so that a toy format can be tested on all of its numbers.
///
/// Model. u = 2^(1 - precision), n = 2^min_exponent. The result of one operation on x and y is exact * (1 + e) + h with
/// |e| <= u. That holds to nearest, upwards, downwards and towards zero (to nearest alone it would hold with u/2), and
/// a compiler that contracts a * b + c to FMA only leaves roundings out. h is the cost of underflow: a result flushed
/// to zero (FTZ) is off by less than n, an operand read as zero (DAZ) by less than n before it is added, and by less
/// than n times the other factor before it is multiplied. Gradual underflow costs less. The guards keep out overflow,
/// and NaN and infinity: a comparison with NaN is false, and false is "unknown". A guard on a sum of magnitudes bounds
/// every one of them, because rounding is monotone and H is a number of the format.
///
/// The rules that the derivations below share, for u <= 1/16:
/// (1) A difference d of two numbers of the input comes out as D with |D - d| <= u |d| + 4 n, so that is at most
///     k |D| + 5 n with k = u / (1 - u).
/// (2) v.x * w.y - v.y * w.x of computed differences, in units of |v.x w.y| + |v.y w.x|: each product is off by 2 k +
///     k^2 (1) and u (its rounding), and at most 1 + u; the subtraction rounds at most 1 + u. Together T = 2 k + k^2 +
///     2 u + u^2 = 4 u + ..., and the computed value is at most (1 + u)^2. Where v is no difference, T is T' = k + 2 u
///     + u^2 = 3 u + ....
/// (3) With e1 + e2 <= H, H >= 2, for the extents e1 and e2 of the factors, the absolute terms of such a polynomial
///     stay below 40 n H: factors cost 11 n H by (1) and 3 n H by DAZ, each product n, the subtraction 4 n.
/// (4) The last operation of all, a subtraction, cannot make a sign wrong. It makes a value greater by a factor 1 + u
///     at most, so it is enough to bound what it subtracts from what, where the sign of that is wrong.
/// (5) A computed bound C e1 e2 + A loses a factor 1 - u for each of its m operations, those in the extents included.
///     It remains to choose C with (1 - u)^m C >= (1 + u) times the sum of the relative terms. Divided by its
///     first term that quotient is a power series in u with positive coefficients, or below one, hence convex, so
///     against a C = c u + d u^2 with the same first term it is enough to check u = 1/16; every C below is a number
///     of the format for double.
/// (6) Underflow in the bound costs 4 n for each addition in the extents, times C H, and 3 n H for the rest.
///
/// Half of the bound of cross_sign or of circle would be too small: the families past_half_the_bound have the inputs.
/// The other three are looser, and give the reasons.
///
/// A filter NAME that says "Proved" has a theorem NAME_right in robust/proofs, about its text as it stands: if it
/// returns a sign, that is the exact one. NAME_binary64 states the same for all doubles, including infinities and NaN:
/// there the theorem includes that the guard excludes overflow. docs/proofs.md lists the formats and the assumptions.
namespace touchstone::robust::filters {

enum class Sign { negative, unknown, positive };

/// The answer that corresponds to a sign.
template <class Answer>
Perhaps<Answer> by_sign(Sign sign, Answer positive, Answer negative) {
  if (sign == Sign::unknown) return {};
  return sign == Sign::positive ? positive : negative;
}

/// The constants of one format.
template <class Float, class Format = FloatFormat<Float>>
struct Bounds {
  static_assert(Format::precision >= 5, "u <= 1/16 is used throughout");
  static_assert(Format::max_exponent >= 7, "the guards below need room");
  static_assert(Format::min_exponent <= 1 - Format::precision, "n <= u <= 1/16");
  static_assert(9 + Format::min_exponent + Format::max_exponent / 3 <= Format::max_exponent, "A is finite, and normal");
  static constexpr double u = power_of_two(1 - Format::precision);

  /// H: 3 H^2 is finite, and above all that is computed from numbers whose magnitudes add up to H. As a third of the
  /// range it leaves about as much room below, where the absolute term hides everything, as above.
  static constexpr int high_exponent = Format::max_exponent / 3;
  static Float high() { return Format::above(power_of_two(high_exponent)); }
  static Float high_squared() { return Format::above(power_of_two(2 * high_exponent)); }
  /// 64 n H
  static Float absolute() { return Format::above(power_of_two(6 + Format::min_exponent + high_exponent)); }
  /// 512 n H
  static Float absolute_of_several() { return Format::above(power_of_two(9 + Format::min_exponent + high_exponent)); }
  /// c u + d u^2, which is exact and so independent of the rounding mode.
  template <int twice_c, int d>
  static Float relative() {
    constexpr double c = twice_c * (u / 2) + d * u * u;
    static_assert(c >= power_of_two(Format::min_exponent), "C is normal: it is never read as zero");
    return Format::above(c);
  }
};

/// The sum of magnitudes.
template <class Float, class Format = FloatFormat<Float>>
Float extent(const Float& a, const Float& b) {
  return Format::magnitude(a) + Format::magnitude(b);
}
template <class Float, class Format = FloatFormat<Float>>
Float extent(const Float& a, const Float& b, const Float& c) {
  return extent<Float, Format>(a, b) + Format::magnitude(c);
}

/// The sign of a computed value that is off by less than error, if the guard holds.
template <class Float, class Format = FloatFormat<Float>>
Sign certain(const Float& value, const Float& error, const Float& size, const Float& high) {
  const int known = Format::magnitude(value) > error, guarded = size <= high;
  if ((known & guarded) == 0) [[unlikely]]  // one branch
    return Sign::unknown;
  return value > Float() ? Sign::positive : Sign::negative;
}

/// The sign of v.x * w.y - v.y * w.x, each coordinate a computed difference of two numbers of the input, or such a
/// number.
///
/// Let p and q be the exact products, P and Q the computed ones, and P > Q although p <= q; then both are positive
/// (else no rounding matters). With the computed factors, v.x w.y = a^2 p and v.y w.x = b^2 p, where a <= 1 + u and b
/// >= 1 - u, so P - Q <= (a^2 (1 + u) - b^2 (1 - u)) p. The extents are those of all x and of all y: ex ey >= v.x w.y +
/// v.y w.x + 2 sqrt(v.x w.y v.y w.x) = (a + b)^2 p. The quotient rises with a and falls with b: it is at most ((1 +
/// u)^3 - (1 - u)^3) / 4 = (3 u + u^3) / 2. m = 5. C = 3/2 u (1 + 8 u): at u = 1/16, 1.470 < 1.5 in units of 3/2 u.
/// Proved.
template <class Float, class Format = FloatFormat<Float>>
Sign cross_sign(const Vector2<Float>& v, const Vector2<Float>& w) {
  using B = Bounds<Float, Format>;
  const Float value = v.x * w.y - v.y * w.x;
  const Float ex = extent<Float, Format>(v.x, w.x), ey = extent<Float, Format>(v.y, w.y);
  return certain<Float, Format>(value, B::template relative<3, 12>() * ex * ey + B::absolute(), ex + ey, B::high());
}

/// Positive: p lies left of p0 -> p1; negative: right. Proved.
template <class Float, class Format = FloatFormat<Float>>
Sign orientation(const Point2<Float>& p0, const Point2<Float>& p1, const Point2<Float>& p) {
  return cross_sign<Float, Format>(p1 - p0, p - p0);
}

/// The sign of radius^2 - v.x^2 - v.y^2, v a computed difference of two points: positive inside the circle.
///
/// The sum of the squares is itself the extent. Let r2 be the exact square of the radius. If the computed inside I is
/// greater than the outside O and should not be, I <= r2 (1 + u) and O >= r2 (1 - u)^4; conversely, I >= r2 (1
/// - u) and O <= r2 (1 + u)^4. (I - O) / (I + O) rises with I / O, so the first is at most ((1 + u) - (1 - u)^4) / ((1
/// + u) + (1 - u)^4), and below 5/2 u (1 + u / 2); where FMA leaves I unrounded in the sum alone, below 5/2 u (1 + u);
/// the other below 5/2 u. m = 3. C = 5/2 u + 16 u^2: at u = 1/16, 1.371 < 1.4 in units of 5/2 u. The guard bounds |v.x|
/// and |v.y| by H (1 + u) and their sum by 3 H / 2, so (3) holds for the two squares of v; to read the radius as zero
/// costs n^2.
///
/// O must be one value in both places, in the difference and in the sum: it is a named sum, so it is computed once, and
/// a compiler can choose only which of its products to contract. Proved.
template <class Float, class Format = FloatFormat<Float>>
Sign circle(const Vector2<Float>& v, const Float& radius) {
  using B = Bounds<Float, Format>;
  const Float inside = radius * radius, outside = v.x * v.x + v.y * v.y;
  const Float sum = inside + outside;
  return certain<Float, Format>(inside - outside, B::template relative<5, 16>() * sum + B::absolute(), sum,
                                B::high_squared());
}

/// The sign of y - (slope * x + intercept): positive above the line.
///
/// Let P be the computed product, s = |P + intercept|, t = |P| + |intercept| >= s, and V the difference of y and the
/// computed sum, of the wrong sign. Then V is at most what the product and the sum are off by, k t + u s = k (t + (1 -
/// u) s). The computed sum is at least (1 - u) s, so |y| >= (1 - u) s - V, and the terms are at least t + (1 - u) s -
/// V. So V <= k / (1 - k) = u / (1 - 2 u) in units of the terms. (With FMA, V <= u s and the terms are at least 2 (1 -
/// u) s - V.) (Looser by about two than it could be: V is a multiple of the last place of y or of the sum.) m = 4. C =
/// u + 10 u^2: at u = 1/16, 1.572 < 1.625 in units of u. Underflow costs 2.2 n H for a factor read as zero, n for the
/// product and 4 n for each of four sums. Proved.
template <class Float, class Format = FloatFormat<Float>>
Sign elevation(const Float& slope, const Float& intercept, const Point2<Float>& p) {
  using B = Bounds<Float, Format>;
  const Float product = slope * p.x;
  const Float value = p.y - (product + intercept);
  const Float terms = extent<Float, Format>(product, intercept, p.y);
  const Float size = terms + extent<Float, Format>(slope, p.x);
  return certain<Float, Format>(value, B::template relative<2, 10>() * terms + B::absolute(), size, B::high());
}

/// Decides whether two segments meet. Negative: they cross; positive: the line of one has the other on one side.
///
/// With r and s the segments as vectors and f from b.a to a.a, ta = (s x f) / (r x s) and tb = (r x f) / (r x s). Both
/// lie strictly between 0 and 1 where |2 (s x f) - r x s| and |2 (r x f) - r x s| are less than |r x s|; one lies
/// outside, or the lines are parallel and not the same, where one of these is greater. The larger of |p + q| and |p -
/// q| is |p| + |q|, so the larger of these two is |s x f + r x f - r x s| + |s x f - r x f|, and its difference from
/// |r x s| decides without a selection.
///
/// With a, b, c the units of (2) for r x s, r x f, s x f: a + b + c <= ex ey. Let D, R, S be these three as computed
/// and N = |S + R - D| + |S - R|, exactly. N is the larger of |2 S - D| and |2 R - D|, so N - |D| is off by at most 2 T
/// max(b, c) + 2 T a <= 2 T (a + b + c), wherever the signs of D, R, S are. The sums before the last are off by u |S +
/// R| and by u N, and round that again with u: u (1 + u)^2 |S + R| + u (2 + u) N in all. |S + R| <= (1 + u)^2 (b + c),
/// and where the value has the wrong sign, N is not much larger than |D|: if N - |D| should be negative, N <= |D| + 2 T
/// (a + b + c). If it should be positive and the value is negative, N as computed is below |D|: (1 - 2 u - u^2) N <=
/// |D| + u (1 + u)^2 |S + R|. So however large N can be, the relative terms are at most 2 T + u (2 + u) ((1 + u)^2 + 2
/// T) = 10 u + ..., in the first case; m = 7. C = 12 u (1 + 20 u): at u = 1/16, 1.67 < 2.25 in units of 12 u. (10 u (1
/// + 16 u) would do. Looser by more than that: the roundings of S and D, and those of the sums, are taken for
/// independent; nothing is known that needs half.) The absolute terms are 160 n H by (3), 10 n H for five sums, and 30
/// n H in the bound: 512 n H pays for them. Proved; segments_meet says it of the segments: negative, and they have one
/// point in common, within both; positive, and they have none.
template <class Float, class Format = FloatFormat<Float>>
Sign segments(const Segment2<Float>& a, const Segment2<Float>& b) {
  using B = Bounds<Float, Format>;
  const Vector2<Float> r = a.b - a.a, s = b.b - b.a, f = a.a - b.a;
  const Float rs = r.x * s.y - r.y * s.x, rf = r.x * f.y - r.y * f.x, sf = s.x * f.y - s.y * f.x;
  const Float value = extent<Float, Format>(sf + rf - rs, sf - rf) - Format::magnitude(rs);
  const Float ex = extent<Float, Format>(r.x, s.x, f.x), ey = extent<Float, Format>(r.y, s.y, f.y);
  return certain<Float, Format>(value, B::template relative<24, 240>() * ex * ey + B::absolute_of_several(), ex + ey,
                                B::high());
}

/// True if a line parallel to an axis lies strictly between two segments. Comparisons do not round; denormals-are-zero
/// can make numbers equal but never reverses a comparison.
template <class Float>
bool apart(const Segment2<Float>& a, const Segment2<Float>& b) {
  const auto larger = [](const Float& p, const Float& q) { return p < q ? q : p; };
  const auto below = [&](const Float& p, const Float& q, const Float& r, const Float& s) {
    return static_cast<int>(larger(p, q) < (r < s ? r : s));
  };
  // A single branch for all axes: the side is unpredictable.
  return (below(a.a.x, a.b.x, b.a.x, b.b.x) | below(b.a.x, b.b.x, a.a.x, a.b.x) | below(a.a.y, a.b.y, b.a.y, b.b.y) |
          below(b.a.y, b.b.y, a.a.y, a.b.y)) != 0;
}

/// Decides whether a ray and a segment meet. Negative: they cross; positive: they do not meet.
///
/// With v the ray's direction, s the segment as a vector and f from the origin to segment.a, the lines meet at
/// -(v x f) / (v x s) on the segment and at t = (f x s) / (v x s) on the ray. The first lies strictly between 0 and 1
/// where one = |v x s| - |2 (v x f) + v x s| is positive and outside where it is negative; t likewise is positive or
/// negative with two = |f x s + v x s| - |f x s - v x s|. The smaller decides, and twice that is one + two - |one -
/// two|.
///
/// With a, b, c the units of (2) for v x s, v x f, f x s, a + b + c <= ex ey, and E, F, G the three as computed. If the
/// sign of the total is wrong, then that of one or of two is, and the value is at most twice that one, and the
/// roundings of one + two and one - two: 2 u times the greater of them, as computed, and that is the wrong one itself
/// or positive.
/// - one: as for segments, at most 2 T' (a + b) before it is rounded. F + F is taken for rounded, by 2 u (1 + u)^2 b,
///   although doubling is exact; 2 F + E is at most |E| and these more, so its rounding costs u times that. A positive
///   two is at most (1 + u)^4 (a + c): (1 + u)^2 by (2), a sum, and the difference. Twice one and the rest: 12 u (a +
///   b) + 4 u b + 2 u a + 2 u (a + c) + ... <= 16 u + ....
/// - two = 2 min(|E|, |G|) with a sign: |E| <= T' a or |G| <= T c, or the sign is right before its two sums round,
///   which costs 2 u max(|E|, |G|) in each case. A positive one is at most (1 + u) |E|. Where G is wrong, 16 u c + 4 u
///   a + 2 u a + ... <= 16 u + ...; where E is, 12 u a + 4 u c + ...; where neither is, 4 u max(a, c) + 2 u a + ....
/// With all terms of higher order it is largest where G is wrong: (1 + u) (2 + 2 u) (2 T + 2 u T) + ... = 1.280 at u =
/// 1/16; one comes to 1.277. m = 7. C = 16 u (1 + 20 u): at u = 1/16, 2.14 < 2.25 in units of 16 u. (Looser by more
/// than two, as for segments.) The absolute terms are 320 n H by (3), 26 n H for the sums, and 40 n H in the bound: 512
/// n H pays for them. Proved; ray_meets says it of the ray and the segment: negative, and they have one point in
/// common, beyond the origin and within the segment; positive, and they have none.
template <class Float, class Format = FloatFormat<Float>>
Sign ray(const Point2<Float>& origin, const Vector2<Float>& v, const Segment2<Float>& segment) {
  using B = Bounds<Float, Format>;
  const Vector2<Float> f = segment.a - origin, s = segment.b - segment.a;
  const Float vs = v.x * s.y - v.y * s.x, vf = v.x * f.y - v.y * f.x, fs = f.x * s.y - f.y * s.x;
  const Float one = Format::magnitude(vs) - Format::magnitude(vf + vf + vs);
  const Float two = Format::magnitude(fs + vs) - Format::magnitude(fs - vs);
  const Float value = Format::magnitude(one - two) - (one + two);
  const Float ex = extent<Float, Format>(v.x, s.x, f.x), ey = extent<Float, Format>(v.y, s.y, f.y);
  return certain<Float, Format>(value, B::template relative<32, 320>() * ex * ey + B::absolute_of_several(), ex + ey,
                                B::high());
}

}  // namespace touchstone::robust::filters
