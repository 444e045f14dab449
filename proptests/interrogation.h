// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>
#include <string>

#include "catalogue/operation/operation.h"

/// Everything that is asked of one question, on one examination of it.
namespace touchstone::proptests {

enum class Aspect {
  robust,          ///< answers as the oracle does, or refuses with the same field and rule; the same in any environment
  stages,          ///< each that knows an answer gives the same, and the last one always knows
  promise,         ///< the formula in double keeps what its contract promises
  certificate,     ///< the checker accepts it
  laws_of_robust,  ///< the symmetries that the row declares
  laws_of_oracle,
};
inline constexpr std::size_t aspect_count = 6;
using Aspects = std::bitset<aspect_count>;
inline bool has(const Aspects& aspects, Aspect aspect) { return aspects[static_cast<std::size_t>(aspect)]; }

/// Those that an operation can be asked for. Robust and oracle of a method are those of its operation.
Aspects aspects_of(const catalogue::Operation& operation);

/// What is wrong, and with which aspect; empty if nothing is. The question is solved once; robust answers it once in
/// the first environment, and once in another (any, but always the same one for the same question).
std::string interrogated(const catalogue::Operation& operation, const catalogue::Question& question,
                         const Aspects& aspects);

}  // namespace touchstone::proptests
