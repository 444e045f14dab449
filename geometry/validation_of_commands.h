// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "geometry/commands.h"
#include "geometry/validation.h"

/// Validation of programs, for doubles and for rationals alike: see validation.h.
namespace touchstone::validation {

/// First all numbers, then the rules of the boxes in their order, then those of the commands; of a command its body
/// before its box.
template <class Real>
void validate_program(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands) {
  validate_numbers("boxes", boxes), validate_numbers("commands", commands);
  validate("boxes", boxes);
  std::vector<bool> there(boxes.size(), true);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    std::visit(
        [&]<class Given>(const Given& command) {
          if constexpr (requires { command.body; }) {
            const bool is_there = command.body < there.size() && there[command.body];
            if (!is_there)
              Refusing{named("commands", {"", i})}(Given::members.at(0), {false, "index of a body that is there"});
          }
          if (!valid(command)) validate(named("commands", {"", i}), command);
          if constexpr (std::is_same_v<Given, Insert<Real>>) there.push_back(true);
          if constexpr (std::is_same_v<Given, Remove>) there[command.body] = false;
        },
        commands[i]);
  }
}

}  // namespace touchstone::validation
