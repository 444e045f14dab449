// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "robust/kernel/contacts/along_normal.h"

/// The velocities of two bodies after an impulse along the normal of their contact: with d = v1 - v2 and b = 1 + e, v1
/// - (b m2 d . n) / ((m1 + m2) n . n) n and v2 + (b m1 d . n) / ((m1 + m2) n . n) n.
namespace touchstone::robust::kernel {

/// True if numbers, and their sum, are 0 or of a magnitude in [2^-60, 2^60]: finite.
///
/// As robust/kernel/enclosed/window.h, for quotients of degree 4 by degree 3. All numbers are multiples of 2^-112, so
/// the numerator is a multiple of 2^-448 below 2^252; the denominator, a product of masses and squares, lies between
/// 2^-180 and 2^192 and is a multiple of 2^-336. A quotient is 0 or lies between 2^-640 and 2^432, its head is a
/// multiple of 2^-666, and what is left, n - q d, is 0 or a multiple of 2^-1002, above 2^-1022. Only that times the
/// inverse, and the tail of the quotient times a number of the input, may underflow: by less than 2^-1022 each, the
/// first times at most 2^60 afterwards. The bound has E 2^-640 to spare for them, times that number, which is 2^-60 or
/// more.
template <class... Numbers>
bool in_narrow_window(Numbers... numbers) {
  using Format = filters::FloatFormat<Two>;
  Two::Bits outside{};
  Two sizes;
  const auto look = [&](Two x) {
    const Two::Lanes size = Format::magnitude(x).lanes;
    // A comparison may read a subnormal as zero, which is small too, so the bits decide whether it is zero. With NaN
    // the sum is not at most 2^60.
    outside |= (size < Two(0x1p-60).lanes) & reinterpret_cast<Two::Bits>(size);
    sizes = sizes + Two(size);
  };
  (look(numbers), ...);
  return (outside[0] | outside[1]) == 0 && sizes <= Two(0x1p60);
}

/// The velocities of both bodies, one per lane: x, y, z.
struct Impelled {
  Two x, y, z;

  Velocitiesd answer() const { return {{x.first(), y.first(), z.first()}, {x.second(), y.second(), z.second()}}; }
};

/// c: -b m2 and b m1. in_narrow_window of all numbers and rounds_to_nearest must hold, and masses must be positive.
/// Returns nullopt if n is 0.
[[gnu::always_inline]] inline std::optional<Impelled> enclosed_impulse(const Massesd& masses,
                                                                       const Velocitiesd& velocities, const Vector3d& n,
                                                                       const Factor<Two>& c) {
  const auto& [v, w] = velocities;
  // d in the first lane, and n - 0 in the second.
  const Vector3<Factor<Two>> normal = factors(n), left{vector_between(Two(w.x, 0), Two(v.x, n.x)),
                                                       vector_between(Two(w.y, 0), Two(v.y, n.y)),
                                                       vector_between(Two(w.z, 0), Two(v.z, n.z))};
  const Enclosed<Two> dots = enclosed_dots(left, normal);
  const Enclosed<double> approach = first(dots), square = second(dots);
  if (square.high == 0) return std::nullopt;
  const Term2<double> below = product(factor(two_sum(masses.first, masses.second)), factor(square));
  const Divisor d(Enclosed<double>{below.head, below.tail, 0});
  const Term2<Two> numerator = product(both(factor(approach), factor(approach)), c);
  const Two size = filters::FloatFormat<Two>::magnitude(c.whole) * Two(approach.error);
  const Share<Two> t = share(numerator, size, both(d.value, d.value), Two(d.inverse));
  const auto x = enclosed_push(Two(v.x, w.x), t, normal.x);
  if (!x) return std::nullopt;
  const auto y = enclosed_push(Two(v.y, w.y), t, normal.y);
  if (!y) return std::nullopt;
  const auto z = enclosed_push(Two(v.z, w.z), t, normal.z);
  if (!z) return std::nullopt;
  return Impelled{*x, *y, *z};
}

/// For b = bounce / one.
Velocitiesd exact_impulse(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& n,
                          const mpz_class& bounce, const mpz_class& one);

}  // namespace touchstone::robust::kernel
