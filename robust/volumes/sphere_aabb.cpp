// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/sphere_aabb.h"

#include "geometry/validation.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// The sign from the radius, then axis by axis the center's coordinate, min and max, all in one unit.
template <class Product, class Integer, std::size_t N>
Contact contact(const std::array<Integer, N>& n) {
  const Integer zero(0);
  Product beyond(0);
  bool interiors = n[0] != zero;
  for (std::size_t k = 1; k < N; k += 3) {
    const Integer &c = n[k], &min = n[k + 1], &max = n[k + 2];
    const Product displacement(c < min ? Integer(min - c) : c > max ? Integer(c - max) : zero);
    beyond += displacement * displacement;
    interiors = interiors && min < max;
  }
  const Product radius(n[0]), squared_radius(radius * radius);
  if (beyond > squared_radius) return Contact::disjoint;
  return beyond < squared_radius && interiors ? Contact::overlapping : Contact::touching;
}

auto lattice_of(const Circle2d& s, const Aabb2d& b) {
  return kernel::lattice_of(s.radius, s.center.x, b.min.x, b.max.x, s.center.y, b.min.y, b.max.y);
}
auto lattice_of(const Sphere3d& s, const Aabb3d& b) {
  return kernel::lattice_of(s.radius, s.center.x, b.min.x, b.max.x, s.center.y, b.min.y, b.max.y, s.center.z, b.min.z,
                            b.max.z);
}
auto integers_of(const Circle2d& s, const Aabb2d& b) {
  return kernel::integers_of(s.radius, s.center.x, b.min.x, b.max.x, s.center.y, b.min.y, b.max.y);
}
auto integers_of(const Sphere3d& s, const Aabb3d& b) {
  return kernel::integers_of(s.radius, s.center.x, b.min.x, b.max.x, s.center.y, b.min.y, b.max.y, s.center.z, b.min.z,
                             b.max.z);
}

template <class Ball, class Box>
void validate_sphere_aabb(const Ball& sphere, const Box& aabb) {
  if (!kernel::valid(sphere) || !kernel::valid(aabb)) validation::validate_all("sphere", sphere, "aabb", aabb);
}

}  // namespace

/// Squares below 2^124, and three of them with a fourth, below 2^122, fit.
template <class Ball, class Box>
Perhaps<Contact> stages::sphere_aabb::lattice(const Ball& sphere, const Box& aabb) {
  const auto lattice = lattice_of(sphere, aabb);
  if (!lattice) return std::nullopt;
  return contact<kernel::Int128>(lattice->at);
}

template <class Ball, class Box>
Contact stages::sphere_aabb::exact(const Ball& sphere, const Box& aabb) {
  return contact<mpz_class>(integers_of(sphere, aabb).at);
}

template <class Ball, class Box>
Decided<Contact> stages::sphere_aabb::past_filter(const Ball& sphere, const Box& aabb) {
  return in_turn<sphere_aabb, validate_sphere_aabb<Ball, Box>, Stage::lattice, Stage::exact>(sphere, aabb);
}

template Perhaps<Contact> stages::sphere_aabb::lattice(const Circle2d&, const Aabb2d&);
template Perhaps<Contact> stages::sphere_aabb::lattice(const Sphere3d&, const Aabb3d&);
template Contact stages::sphere_aabb::exact(const Circle2d&, const Aabb2d&);
template Contact stages::sphere_aabb::exact(const Sphere3d&, const Aabb3d&);
template Decided<Contact> stages::sphere_aabb::past_filter(const Circle2d&, const Aabb2d&);
template Decided<Contact> stages::sphere_aabb::past_filter(const Sphere3d&, const Aabb3d&);

}  // namespace touchstone::robust
