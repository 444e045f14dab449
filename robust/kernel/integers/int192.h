// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/integers/lattice.h"

namespace touchstone::robust::kernel {

/// A signed 192-bit integer (two's complement, least limb first): the third-degree numbers of the lattice, all below
/// 2^190.
struct Int192 {
  std::array<std::uint64_t, 3> limb;
};

inline UInt128 magnitude_of(Int128 n) { return n < 0 ? -static_cast<UInt128>(n) : static_cast<UInt128>(n); }
inline std::uint64_t magnitude_of(std::int64_t n) {
  return n < 0 ? -static_cast<std::uint64_t>(n) : static_cast<std::uint64_t>(n);
}

inline Int192 operator+(const Int192& a, const Int192& b) {
  Int192 sum{};
  UInt128 carry = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    carry += static_cast<UInt128>(a.limb[i]) + b.limb[i];
    sum.limb[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  return sum;
}

inline Int192 operator-(const Int192& a) { return Int192{{~a.limb[0], ~a.limb[1], ~a.limb[2]}} + Int192{{1, 0, 0}}; }

inline int sign_of(const Int192& a) { return a.limb[2] >> 63 ? -1 : (a.limb[0] | a.limb[1] | a.limb[2]) != 0; }

/// |a| < 2^126, |b| < 2^63.
inline Int192 multiply(Int128 a, std::int64_t b) {
  const UInt128 size = magnitude_of(a);
  const std::uint64_t factor = magnitude_of(b);
  const UInt128 low = static_cast<UInt128>(static_cast<std::uint64_t>(size)) * factor;
  const UInt128 high = (size >> 64) * factor + (low >> 64);
  const Int192 product{
      {static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high), static_cast<std::uint64_t>(high >> 64)}};
  return (a < 0) != (b < 0) ? -product : product;
}

}  // namespace touchstone::robust::kernel
