// SPDX-License-Identifier: Apache-2.0
#include "robust/response/kinetic_energy.h"

#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/shapes/whole_bodies.h"

namespace touchstone::robust {

/// The degree is 3, well within the window. A sum of squares is settled, so each term is a product like those of Sum,
/// except for mass times the error of the square, which is carried separately.
Perhaps<double> stages::kinetic_energy::enclosed(const std::vector<Bodyd>& bodies) {
  using namespace kernel;
  if (bodies.size() > most_enclosed_bodies || !rounds_to_nearest()) return std::nullopt;
  const Two zero;
  Window window(zero);
  Sum<Two> sum(Term2<Two>{zero, zero});
  Two carried;
  for (std::size_t i = 0; i < bodies.size(); i += 2) {
    const TwoBodies two = two_bodies(bodies, i);
    window.add(two.mass).add(two.x).add(two.y).add(two.z);
    if (!positive(two.mass)) return std::nullopt;
    const Factor<Two> x = factor(two.x), y = factor(two.y), z = factor(two.z);
    Sum<Two> squares(product(x, x));
    squares += product(y, y), squares += product(z, z);
    const Enclosed<Two> square = squares.value();
    sum += product(factor(two.mass), factor(square));
    carried = carried + two.mass * square.error;
  }
  if (!window.holds()) return std::nullopt;
  Enclosed<Two> doubled = sum.value();
  doubled.error = doubled.error + Two(1.25) * carried;
  const Enclosed<double> total = first(doubled) + second(doubled);
  const auto energy = rounded(Enclosed<double>{total.high / 2, total.low / 2, total.error / 2});
  if (!energy) return std::nullopt;
  return *energy;
}

double stages::kinetic_energy::exact(const std::vector<Bodyd>& bodies) {
  const kernel::IntegerBodies integers = kernel::integer_bodies(bodies);
  mpz_class doubled;
  for (const auto& [mass, velocity] : integers.at) doubled += mass * dot(velocity, velocity);
  return kernel::round_scaled(doubled, integers.mass_exponent + 2 * integers.velocity_exponent - 1);
}

namespace {

void validate_bodies_of_kinetic_energy(const std::vector<Bodyd>& bodies) {
  if (!kernel::valid(bodies)) validation::validate("bodies", bodies);
}

}  // namespace

Decided<double> stages::kinetic_energy::ask(const std::vector<Bodyd>& bodies) {
  return in_turn<kinetic_energy, Stage::enclosed, validate_bodies_of_kinetic_energy, Stage::exact>(bodies);
}

double kinetic_energy(const std::vector<Bodyd>& bodies) { return stages::kinetic_energy::ask(bodies).answer; }

}  // namespace touchstone::robust
