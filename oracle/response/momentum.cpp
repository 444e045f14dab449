// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/momentum.h"

#include "oracle/exact/shapes/many_bodies.h"

namespace touchstone::oracle {
namespace {

Truth<Vector3<Rational>> truth_momentum(const ManyBodies& bodies) {
  Integer mass;
  Vector3<Integer> sum{};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    mass += bodies.mass(i);
    sum = sum + mass * (bodies.velocity(i) - bodies.velocity(i + 1));
  }
  return {{bodies.actual(sum.x, 1), bodies.actual(sum.y, 1), bodies.actual(sum.z, 1)}, std::nullopt, [] {
            return Certificate{"sum", {}};
          }};
}

}  // namespace

template <Exact Number>
Truth<Vector3<Rational>> momentum(const std::vector<Body<Number>>& bodies) {
  return truth_momentum(ManyBodies(bodies));
}
template Truth<Vector3<Rational>> momentum(const std::vector<Bodyd>&);
template Truth<Vector3<Rational>> momentum(const std::vector<Body<Rational>>&);

}  // namespace touchstone::oracle
