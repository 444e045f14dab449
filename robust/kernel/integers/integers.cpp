// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/integers.h"

#include <cstdint>

#include "robust/kernel/integers/term_sum.h"

namespace touchstone::robust::kernel {
namespace {

mpz_class shifted(mpz_class n, int shift, bool negative) {
  n <<= static_cast<std::uint64_t>(shift);
  if (negative) mpz_neg(n.get_mpz_t(), n.get_mpz_t());
  return n;
}

}  // namespace

mpz_class scaled(const Decoded& part, int shift) {
  return shifted(mpz_class(static_cast<std::uint64_t>(part.magnitude)), shift, part.negative);
}

mpz_class scaled(const Term& t, int shift) {
  mpz_class n(static_cast<std::uint64_t>(t.magnitude >> 64));
  n <<= 64;
  n += static_cast<std::uint64_t>(t.magnitude);
  return shifted(n, shift, t.negative);
}

mpz_class integer_of(Int128 n) {
  return scaled(Term{n < 0 ? -static_cast<UInt128>(n) : static_cast<UInt128>(n), 0, n < 0}, 0);
}

}  // namespace touchstone::robust::kernel
