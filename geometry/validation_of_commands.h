// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"

/// Validation of programs, for doubles and for rationals alike: see validation.h.
namespace touchstone::validation {

/// The boxes in their order, then the commands; of a command its body before its box. `validate_box(field, box)` holds
/// the rules of a box.
template <class Real, class ValidateBox>
void validate_program(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands,
                      const ValidateBox& validate_box) {
  struct Validate {
    const ValidateBox& validate_box;
    std::vector<bool> there{};
    std::string field{};

    void require(Index body, const char* member) const {
      if (body >= there.size() || !there[body]) throw InvalidInput(field + member, "index of a body that is there");
    }
    void operator()(const Insert<Real>& command) {
      validate_box(field + ".insert", command.box);
      there.push_back(true);
    }
    void operator()(const Move<Real>& command) {
      require(command.body, ".move");
      validate_box(field + ".box", command.box);
    }
    void operator()(const Remove& command) {
      require(command.body, ".remove");
      there[command.body] = false;
    }
    void operator()(const Ask&) {}
  } validate{validate_box};
  for (std::size_t i = 0; i < boxes.size(); ++i) validate_box("boxes[" + std::to_string(i) + "]", boxes[i]);
  validate.there.assign(boxes.size(), true);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    validate.field = "commands[" + std::to_string(i) + "]";
    std::visit([&validate](const auto& command) { validate(command); }, commands[i]);
  }
}

}  // namespace touchstone::validation
