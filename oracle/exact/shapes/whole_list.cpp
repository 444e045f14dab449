// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/whole_list.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace touchstone::oracle {

IntegerList integer_list(const std::vector<double>& numbers) {
  const int none = 4096;  // no finite double has an exponent like that
  int least = none;
  const auto zeros = [](const Dyadic& part) { return std::countr_zero(static_cast<std::uint64_t>(part.mantissa)); };
  for (const double number : numbers) {
    const Dyadic part = decode(number);
    if (part.mantissa != 0) least = std::min(least, part.exponent + zeros(part));
  }
  IntegerList result{{}, scaled(Rational(1), least == none ? 0 : least)};
  for (const double number : numbers) {
    const Dyadic part = decode(number);
    const int last = part.mantissa == 0 ? 0 : zeros(part);
    Integer integer(static_cast<std::int64_t>(part.mantissa >> last));
    if (part.mantissa != 0) integer <<= static_cast<mp_bitcnt_t>(part.exponent + last - least);
    result.integers.push_back(std::move(integer));
  }
  return result;
}

IntegerList integer_list(const std::vector<Rational>& numbers) {
  Integer denominator(1);
  for (const Rational& number : numbers) {
    mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), number.get_den_mpz_t());
  }
  IntegerList result{{}, Rational(Integer(1), denominator)};
  for (const Rational& number : numbers) result.integers.push_back(number.get_num() * (denominator / number.get_den()));
  return result;
}

}  // namespace touchstone::oracle
