// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/certificates/check_bodies.h"

/// Balls and walls before a step, in the form of claims, each with the rules of its shape.
namespace touchstone::certify {

struct Mover {
  Rational inverse_mass;
  Triple velocity;
  Ball ball;
  bool moves() const { return sgn(inverse_mass) != 0; }
};

inline const Triple nothing{0, 0, 0};

/// `bodies` and `walls` of a claim's input.
std::vector<Mover> movers(const json& value);
std::vector<Plane> planes(const json& value);

}  // namespace touchstone::certify
