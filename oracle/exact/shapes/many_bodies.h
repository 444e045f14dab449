// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/shapes/whole_list.h"

namespace touchstone::oracle {

/// Validated bodies of a list: masses as integers in one unit, velocities in another.
struct ManyBodies {
  IntegerList masses, speeds;

  template <class Number>
  explicit ManyBodies(const std::vector<Body<Number>>& bodies) {
    std::vector<Number> of_masses, of_speeds;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      validation::validate_numbers("bodies[" + std::to_string(i) + "]", bodies[i]);
    for (const auto& [mass, velocity] : bodies) {
      validation::validate("bodies[" + std::to_string(of_masses.size()) + "]", Body<Number>{mass, velocity});
      of_masses.push_back(mass);
      of_speeds.insert(of_speeds.end(), {velocity.x, velocity.y, velocity.z});
    }
    masses = integer_list(of_masses), speeds = integer_list(of_speeds);
  }

  std::size_t size() const { return masses.integers.size(); }
  const Integer& mass(std::size_t i) const { return masses.integers[i]; }
  /// The velocity of body i, 0 beyond the last.
  Vector3<Integer> velocity(std::size_t i) const {
    if (i == size()) return {Integer(0), Integer(0), Integer(0)};
    return {speeds.integers[3 * i], speeds.integers[3 * i + 1], speeds.integers[3 * i + 2]};
  }
  /// A number in units of mass times velocity to that power.
  Rational actual(const Rational& value, int speed_degree) const {
    return speeds.actual(masses.actual(value, 1), speed_degree);
  }
};

}  // namespace touchstone::oracle
