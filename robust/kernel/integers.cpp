// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers.h"

namespace touchstone::robust::kernel {

mpz_class scaled(const Decoded& part, int shift) {
  static_assert(sizeof(unsigned long) == sizeof(std::uint64_t), "GMP's word holds a significand");
  mpz_class result(static_cast<unsigned long>(part.magnitude));
  result <<= static_cast<unsigned long>(shift);
  if (part.negative) mpz_neg(result.get_mpz_t(), result.get_mpz_t());
  return result;
}

}  // namespace touchstone::robust::kernel
