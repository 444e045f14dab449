// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/whole.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "oracle/exact/numbers/common_scale.h"

namespace touchstone::oracle {

IntegerRing::IntegerRing(const Polygon2d& polygon) {
  const int none = 4096;  // no finite double has an exponent like that
  int least = none;
  const auto lower = [&](double number) {
    const Dyadic part = decode(number);
    if (part.mantissa != 0)
      least = std::min(least, part.exponent + std::countr_zero(static_cast<std::uint64_t>(part.mantissa)));
  };
  for (const Point2d& p : polygon.vertices) lower(p.x), lower(p.y);
  const auto integer = [&](double number) {
    const Dyadic part = decode(number);
    Integer result(static_cast<std::int64_t>(part.mantissa));
    const int up = part.exponent - least;
    if (up >= 0) {
      result <<= static_cast<mp_bitcnt_t>(up);
    } else {
      result >>= static_cast<mp_bitcnt_t>(-up);  // only zeros leave
    }
    return result;
  };
  for (const Point2d& p : polygon.vertices) ring.vertices.push_back({integer(p.x), integer(p.y)});
  unit = scaled(Rational(1), least == none ? 0 : least);
  find_words();
}

IntegerRing::IntegerRing(const Polygon2<Rational>& polygon) {
  Integer denominator(1);
  for (const auto& p : polygon.vertices) {
    for (const Rational* number : {&p.x, &p.y})
      mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), number->get_den_mpz_t());
  }
  const auto integer = [&](const Rational& number) {
    return Integer(number.get_num() * (denominator / number.get_den()));
  };
  for (const auto& p : polygon.vertices) ring.vertices.push_back({integer(p.x), integer(p.y)});
  unit = Rational(Integer(1), denominator);
  find_words();
}

void IntegerRing::find_words() {
  const auto fits = [](const Integer& number) { return mpz_sizeinbase(number.get_mpz_t(), 2) <= most_bits_in_words; };
  for (const auto& p : ring.vertices) {
    if (!fits(p.x) || !fits(p.y)) return words.clear();
    words.push_back({p.x.get_si(), p.y.get_si()});
  }
}

std::vector<Segment2<Integer>> IntegerRing::edges() const {
  std::vector<Segment2<Integer>> all;
  for (std::size_t i = 0; i < ring.size(); ++i) all.push_back(edge(i));
  return all;
}

Integer IntegerRing::area(const Point2<Integer>& p, const Point2<Integer>& q, const Point2<Integer>& r) {
  return cross(q - p, r - p);
}

int IntegerRing::turn(Index i, Index j, Index k) const {
  if (words.empty()) return sgn(area(i, j, k));
  const auto &p = words[i], &q = words[j], &r = words[k];
  return sgn(Int128{q.x - p.x} * (r.y - p.y) - Int128{q.y - p.y} * (r.x - p.x));
}

Integer IntegerRing::area(const std::vector<Index>& piece) const {
  Integer sum;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Point2<Integer>&p = ring[piece[i]], &q = ring[piece[(i + 1) % piece.size()]];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

Integer IntegerRing::area() const {
  std::vector<Index> all(size());
  std::iota(all.begin(), all.end(), Index{0});
  return area(all);
}

}  // namespace touchstone::oracle
