// SPDX-License-Identifier: Apache-2.0
#include "robust/response/damped_reflection.h"

#include "robust/kernel/contacts/along_normal.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// v - (1 + k) (v . n / n . n) n. A normal of 0 makes NaN, as in reflect_plane.
///
/// A quotient of degree 3 by degree 2, one more than where lines cross (robust/kernel/enclosed/window.h): it is 0 or
/// lies between 2^-668 and 2^512, its head is a multiple of 2^-694, and what is left of the numerator one of 2^-998,
/// above 2^-1022. Later underflow is below 2^-1022, or 2^-922 after a product with a number of the input,
/// and E 2^-768 holds it.
[[gnu::always_inline]] inline std::optional<kernel::Pushed> enclosed_velocity(const Vector3d& v, const Vector3d& n,
                                                                              double k) {
  using namespace kernel;
  if (!in_window(Two(v.x, n.x), Two(v.y, n.y), Two(v.z, n.z), Two(k, 0)) || !rounds_to_nearest()) return std::nullopt;
  const Enclosed<Two> dots = approach_and_square(v, n);
  const Enclosed<Two> approach = twice(first(dots)), square = twice(second(dots));
  const Pair<Two> gain = two_sum(Two(1), Two(k));
  const Term2<Two> back = product(factor(approach), factor(Pair<Two>{-gain.high, -gain.low}));
  const Two size = filters::FloatFormat<Two>::magnitude(gain.high) * approach.error;
  const Divisor d(square);
  return enclosed_push(v, share(back, size, d.value, d.inverse), n);
}

void validate_damped_reflection(const Vector3d& velocity, const Vector3d& normal, double k) {
  if (kernel::valid(velocity) && kernel::valid(normal, rule::normal) && kernel::all_finite(k)) return;
  validation::validate_all("velocity", velocity, "normal", validation::under(rule::normal, normal), "k", k);
}

}  // namespace

Perhaps<Vector3d> stages::damped_reflection::enclosed(const Vector3d& v, const Vector3d& n, double k) {
  if (const auto after = enclosed_velocity(v, n, k)) return after->answer();
  return std::nullopt;
}

Vector3d stages::damped_reflection::exact(const Vector3d& v, const Vector3d& n, double k) {
  const kernel::Integers<3> velocity = kernel::integers_of(v);
  const Vector3<mpz_class> integer_velocity = kernel::integer_vector(velocity),
                           normal = kernel::integer_vector(kernel::integers_of(n));
  const auto [one, factor] = kernel::integers_of(1.0, k).at;
  const mpz_class back = -(one + factor) * dot(integer_velocity, normal), below = one * dot(normal, normal);
  return kernel::pushed(integer_velocity, back, below, normal, velocity.exponent);
}

Decided<Vector3d> stages::damped_reflection::ask(const Vector3d& v, const Vector3d& n, double k) {
  return in_turn<damped_reflection, Stage::enclosed, validate_damped_reflection, Stage::exact>(v, n, k);
}

Vector3d damped_reflection(const Vector3d& velocity, const Vector3d& normal, double k) {
  if (const auto after = enclosed_velocity(velocity, normal, k)) return after->answer();
  return answer_in_turn<stages::damped_reflection, validate_damped_reflection, Stage::exact>(velocity, normal, k);
}

}  // namespace touchstone::robust
