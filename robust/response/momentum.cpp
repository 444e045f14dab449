// SPDX-License-Identifier: Apache-2.0
#include "robust/response/momentum.h"

#include <cstdint>

#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/shapes/whole_bodies.h"

namespace touchstone::robust {

/// The degree is 2, well within the window.
Perhaps<Vector3d> stages::momentum::enclosed(const std::vector<Bodyd>& bodies) {
  using namespace kernel;
  if (bodies.size() > most_enclosed_bodies || !rounds_to_nearest()) return std::nullopt;
  const Two zero;
  Window window(zero);
  Sum<Two> x(Term2<Two>{zero, zero}), y = x, z = x;
  for (std::size_t i = 0; i < bodies.size(); i += 2) {
    const TwoBodies two = two_bodies(bodies, i);
    window.add(two.mass).add(two.x).add(two.y).add(two.z);
    if (!positive(two.mass)) return std::nullopt;
    const Factor<Two> mass = factor(two.mass);
    x += product(mass, factor(two.x)), y += product(mass, factor(two.y)), z += product(mass, factor(two.z));
  }
  if (!window.holds()) return std::nullopt;
  const Enclosed<Two> of_x = x.value(), of_y = y.value(), of_z = z.value();
  const auto xy = rounded(both(first(of_x), first(of_y)) + both(second(of_x), second(of_y)));
  if (!xy) return std::nullopt;
  const auto of_both = rounded(first(of_z) + second(of_z));
  if (!of_both) return std::nullopt;
  return {in_place, xy->first(), xy->second(), *of_both};
}

Vector3d stages::momentum::exact(const std::vector<Bodyd>& bodies) {
  const kernel::IntegerBodies integers = kernel::integer_bodies(bodies);
  Vector3<mpz_class> sum{};
  for (const auto& [mass, velocity] : integers.at) sum = sum + mass * velocity;
  const std::int64_t exponent = static_cast<std::int64_t>(integers.mass_exponent) + integers.velocity_exponent;
  const auto rounded = [exponent](const mpz_class& n) { return kernel::round_scaled(n, exponent); };
  return {rounded(sum.x), rounded(sum.y), rounded(sum.z)};
}

namespace {

void validate_bodies_of_momentum(const std::vector<Bodyd>& bodies) {
  if (!kernel::valid(bodies)) validation::validate("bodies", bodies);
}

}  // namespace

Decided<Vector3d> stages::momentum::ask(const std::vector<Bodyd>& bodies) {
  return in_turn<momentum, Stage::enclosed, validate_bodies_of_momentum, Stage::exact>(bodies);
}

Vector3d momentum(const std::vector<Bodyd>& bodies) {
  return answer_in_turn<stages::momentum, Stage::enclosed, validate_bodies_of_momentum, Stage::exact>(bodies);
}

}  // namespace touchstone::robust
