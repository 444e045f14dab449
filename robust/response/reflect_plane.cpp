// SPDX-License-Identifier: Apache-2.0
#include "robust/response/reflect_plane.h"

#include "robust/kernel/contacts/along_normal.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// v - 2 (v . n / n . n) n: the window is that of line crossings. A normal of 0, which is refused, makes NaN, which
/// nothing encloses.
[[gnu::always_inline]] inline std::optional<kernel::Pushed> enclosed_velocity(const Vector3d& v, const Vector3d& n) {
  using namespace kernel;
  if (!in_window(Two(v.x, n.x), Two(v.y, n.y), Two(v.z, n.z)) || !rounds_to_nearest()) return std::nullopt;
  const Enclosed<Two> dots = approach_and_square(v, n);
  const Enclosed<Two> approach = twice(first(dots)), square = twice(second(dots));
  const Term2<Two> twice_back{Two(-2) * approach.high, Two(-2) * approach.low};
  const Divisor d(square);
  return enclosed_push(v, share(twice_back, Two(2) * approach.error, d.value, d.inverse), n);
}

void validate_reflect_plane(const Vector3d& velocity, const Vector3d& normal) {
  if (kernel::valid(velocity) && kernel::valid(normal, rule::normal)) return;
  validation::validate("velocity", velocity), validation::validate("normal", normal, rule::normal);
}

}  // namespace

Perhaps<Vector3d> stages::reflect_plane::enclosed(const Vector3d& v, const Vector3d& n) {
  if (const auto after = enclosed_velocity(v, n)) return after->answer();
  return std::nullopt;
}

Vector3d stages::reflect_plane::exact(const Vector3d& v, const Vector3d& n) {
  const kernel::Integers<3> velocity = kernel::integers_of(v);
  const Vector3<mpz_class> integer_velocity = kernel::integer_vector(velocity),
                           normal = kernel::integer_vector(kernel::integers_of(n));
  const mpz_class twice_back = -2 * dot(integer_velocity, normal);
  return kernel::pushed(integer_velocity, twice_back, dot(normal, normal), normal, velocity.exponent);
}

Decided<Vector3d> stages::reflect_plane::ask(const Vector3d& v, const Vector3d& n) {
  return in_turn<reflect_plane, Stage::enclosed, validate_reflect_plane, Stage::exact>(v, n);
}

Vector3d reflect_plane(const Vector3d& velocity, const Vector3d& normal) {
  if (const auto after = enclosed_velocity(velocity, normal)) return after->answer();
  return answer_in_turn<stages::reflect_plane, validate_reflect_plane, Stage::exact>(velocity, normal);
}

}  // namespace touchstone::robust
