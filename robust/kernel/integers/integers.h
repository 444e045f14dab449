// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <array>
#include <climits>

#include "geometry/points.h"
#include "geometry/space.h"
#include "robust/kernel/integers/lattice.h"

namespace touchstone::robust::kernel {

/// Several doubles as GMP integers over one power of two: number i is at[i] * 2^exponent exactly.
template <std::size_t N>
struct Integers {
  std::array<mpz_class, N> at;
  int exponent;
};

/// part * 2^shift, shift >= 0.
mpz_class scaled(const Decoded& part, int shift);

template <class... Doubles>
Integers<sizeof...(Doubles)> integers_of(Doubles... numbers) {
  constexpr std::size_t n = sizeof...(Doubles);
  const std::array<Decoded, n> parts{decode(numbers)...};
  int low = INT_MAX;
  for (const Decoded& part : parts)
    if (part.magnitude != 0) low = std::min(low, part.exponent + std::countr_zero(part.magnitude));
  Integers<n> result;
  result.exponent = low == INT_MAX ? 0 : low;
  for (std::size_t i = 0; i < n; ++i)
    if (parts[i].magnitude != 0) {
      const int zeros = std::countr_zero(parts[i].magnitude);
      const Decoded odd{parts[i].magnitude >> zeros, 0, parts[i].negative};
      result.at[i] = scaled(odd, parts[i].exponent + zeros - low);
    }
  return result;
}

inline int sign_of(const mpz_class& n) { return sgn(n); }

/// Three consecutive numbers, from number i on.
template <class Numbers>
auto vector_at(const Numbers& n, std::size_t i) {
  return Vector3<typename Numbers::value_type>{n[i], n[i + 1], n[i + 2]};
}

}  // namespace touchstone::robust::kernel
