// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/whole_bodies.h"

namespace touchstone::robust::kernel {
namespace {

/// The least exponent among nonzero numbers, and integers over it.
class CommonUnit {
 public:
  void add(double number) {
    const Decoded part = decode(number);
    if (part.magnitude != 0) least_ = std::min(least_, part.exponent);
  }
  int exponent() const { return least_ == INT_MAX ? 0 : least_; }
  mpz_class integer(double number) const {
    const Decoded part = decode(number);
    return part.magnitude == 0 ? mpz_class(0) : scaled(part, part.exponent - least_);
  }

 private:
  int least_ = INT_MAX;
};

}  // namespace

IntegerBodies integer_bodies(const std::vector<Bodyd>& bodies) {
  CommonUnit mass, speed;
  for (const Bodyd& body : bodies)
    mass.add(body.mass), speed.add(body.velocity.x), speed.add(body.velocity.y), speed.add(body.velocity.z);
  IntegerBodies result{{}, mass.exponent(), speed.exponent()};
  result.at.reserve(bodies.size());
  for (const auto& [m, v] : bodies)
    result.at.push_back({mass.integer(m), {speed.integer(v.x), speed.integer(v.y), speed.integer(v.z)}});
  return result;
}

}  // namespace touchstone::robust::kernel
