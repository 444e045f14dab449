// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/spheres.h"

#include "robust/kernel/integers/integers.h"

namespace touchstone::robust::kernel {
namespace {

/// The sign for two spheres, each given by center and radius.
template <class Product, class Integer>
int sign_of_reach(const std::array<Integer, 8>& n) {
  const auto squared = [](const Integer& x) { return Product(Product(x) * Product(x)); };
  const Product inside = squared(Integer(n[3] + n[7]));
  return sign_of(
      Product(inside - squared(Integer(n[4] - n[0])) - squared(Integer(n[5] - n[1])) - squared(Integer(n[6] - n[2]))));
}

}  // namespace

Perhaps<int> Reach::lattice(const Sphere3d& a, const Sphere3d& b) {
  const auto lattice =
      lattice_of(a.center.x, a.center.y, a.center.z, a.radius, b.center.x, b.center.y, b.center.z, b.radius);
  if (!lattice) return std::nullopt;
  return sign_of_reach<Int128>(lattice->at);
}

int Reach::exact(const Sphere3d& a, const Sphere3d& b) {
  const auto numbers =
      integers_of(a.center.x, a.center.y, a.center.z, a.radius, b.center.x, b.center.y, b.center.z, b.radius);
  return sign_of_reach<mpz_class>(numbers.at);
}

Decided<int> Reach::past_filter(const Sphere3d& a, const Sphere3d& b) {
  return in_turn<Reach, Stage::lattice, Stage::exact>(a, b);
}

}  // namespace touchstone::robust::kernel
