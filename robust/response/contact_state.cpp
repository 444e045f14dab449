// SPDX-License-Identifier: Apache-2.0
#include "robust/response/contact_state.h"

#include <cstdint>
#include <tuple>

#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

using kernel::Int128;

ContactState state(int sign) {
  return sign > 0 ? ContactState::separating : sign < 0 ? ContactState::colliding : ContactState::resting;
}

/// Velocities, angular velocities, positions and the normal, each over its own power of two. `numbers` takes any count
/// of doubles.
template <class Numbers>
auto in_units(const MovingBodyd& a, const MovingBodyd& b, const Point3d& p, const Vector3d& n, const Numbers& numbers) {
  const auto six = [&numbers](const auto& v, const auto& w) { return numbers(v.x, v.y, v.z, w.x, w.y, w.z); };
  const Point3d &x = a.position, &y = b.position;
  return std::tuple(six(a.velocity, b.velocity), six(a.angular_velocity, b.angular_velocity),
                    numbers(x.x, x.y, x.z, y.x, y.y, y.z, p.x, p.y, p.z), numbers(n.x, n.y, n.z));
}

/// va - vb, in units of velocities.
template <class Velocities>
auto straight_part(const Velocities& v) {
  using Integer = typename Velocities::value_type;
  return Vector3<Integer>{Integer(v[0] - v[3]), Integer(v[1] - v[4]), Integer(v[2] - v[5])};
}
/// wa x (p - a) - wb x (p - b), in units of angular velocity times position. On a lattice positions differ by less than
/// 2^62: four products below 2^123 each.
template <class Turns, class Places>
auto turning_part(const Turns& w, const Places& places) {
  using Integer = typename Turns::value_type;
  const auto arm = [&places](std::size_t i) {
    return Vector3<Integer>{Integer(places[6] - places[i]), Integer(places[7] - places[i + 1]),
                            Integer(places[8] - places[i + 2])};
  };
  return kernel::axis_across(kernel::vector_at(w, 0), arm(0)) - kernel::axis_across(kernel::vector_at(w, 3), arm(3));
}

/// Shifts out their common trailing zeros.
template <std::size_t N>
kernel::Lattice<N> reduced(kernel::Lattice<N> numbers) {
  std::uint64_t bits = std::uint64_t{1} << 61;
  for (const std::int64_t n : numbers.at) bits |= kernel::magnitude_of(n);
  const int zeros = std::countr_zero(bits);
  for (std::int64_t& n : numbers.at) n >>= zeros;  // exact: no set bit is lost
  numbers.exponent += zeros;
  return numbers;
}

/// n * 2^shift, if that stays below 2^125 in magnitude.
std::optional<Int128> shifted(Int128 n, int shift) {
  if (n == 0) return n;
  const kernel::UInt128 size = kernel::magnitude_of(n);
  if (shift > 124 || size >> (125 - shift) != 0) return std::nullopt;
  return n * (static_cast<Int128>(1) << shift);
}
std::optional<Vector3<Int128>> shifted(const Vector3<Int128>& v, int shift) {
  const auto x = shifted(v.x, shift), y = shifted(v.y, shift), z = shifted(v.z, shift);
  if (!x || !y || !z) return std::nullopt;
  return Vector3<Int128>{*x, *y, *z};
}

void validate_contact_state(const MovingBodyd& a, const MovingBodyd& b, const Point3d& point, const Vector3d& normal) {
  if (kernel::valid(a) && kernel::valid(b) && kernel::valid(point) && kernel::valid(normal, rule::normal)) return;
  validation::validate_all("a", a, "b", b, "point", point, "normal", validation::under(rule::normal, normal));
}

}  // namespace

/// Both parts of the relative velocity are below 2^125, their sum is below 2^126, and its product with the normal below
/// 2^189.
Perhaps<ContactState> stages::contact_state::lattice(const MovingBodyd& a, const MovingBodyd& b, const Point3d& point,
                                                     const Vector3d& normal) {
  using kernel::multiply;
  const auto [velocities, turns, places, n] =
      in_units(a, b, point, normal, [](auto... number) { return kernel::lattice_of(number...); });
  if (!velocities || !turns || !places || !n) return std::nullopt;
  const auto v = reduced(*velocities);
  const auto w = reduced(*turns);
  const auto p = reduced(*places);
  const Vector3<std::int64_t> integers = straight_part(v.at);
  const int finer = v.exponent - (w.exponent + p.exponent);  // how much finer the unit of rotation is
  const auto straight = shifted(Vector3<Int128>{integers.x, integers.y, integers.z}, std::max(finer, 0)),
             turning = shifted(turning_part(w.at, p.at), std::max(-finer, 0));
  if (!straight || !turning) return std::nullopt;
  const Vector3<Int128> apart = *straight + *turning;
  return state(
      kernel::sign_of(multiply(apart.x, n->at[0]) + multiply(apart.y, n->at[1]) + multiply(apart.z, n->at[2])));
}

ContactState stages::contact_state::exact(const MovingBodyd& a, const MovingBodyd& b, const Point3d& point,
                                          const Vector3d& normal) {
  const auto [v, w, p, n] =
      in_units(a, b, point, normal, [](auto... number) { return kernel::integers_of(number...); });
  const Vector3<mpz_class> direction = kernel::vector_at(n.at, 0);
  mpz_class straight = dot(straight_part(v.at), direction), turning = dot(turning_part(w.at, p.at), direction);
  const int finer = v.exponent - (w.exponent + p.exponent);
  mpz_class& coarser = finer > 0 ? straight : turning;
  coarser <<= static_cast<std::uint64_t>(std::abs(finer));
  return state(sgn(mpz_class(straight + turning)));
}

Decided<ContactState> stages::contact_state::past_filter(const MovingBodyd& a, const MovingBodyd& b,
                                                         const Point3d& point, const Vector3d& normal) {
  return in_turn<contact_state, validate_contact_state, Stage::lattice, Stage::exact>(a, b, point, normal);
}

}  // namespace touchstone::robust
