// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "catalogue/judge/environment.h"

namespace touchstone::proptests {

using catalogue::Environment, catalogue::environment_count, catalogue::environment_name, catalogue::in_environment;

/// An answer as words: enumerators, presence of optional parts, numbers bit by bit. Never compares doubles.
struct AnswerBits {
  std::vector<std::uint64_t> words;
  std::string refused;
  friend bool operator==(const AnswerBits&, const AnswerBits&) = default;
};

}  // namespace touchstone::proptests
