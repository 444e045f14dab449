// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"

/// Validation of programs, for doubles and for rationals alike: see validation.h.
namespace touchstone::validation {

/// First all numbers, then the rules of the boxes in their order, then those of the commands; of a command its body
/// before its box. `validate_numbers(field, box)` and `validate_box(field, box)` hold those of a box.
template <class Real, class ValidateNumbers, class ValidateBox>
void validate_program(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands,
                      const ValidateNumbers& validate_numbers, const ValidateBox& validate_box) {
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
  const auto box_field = [](std::size_t i) { return "boxes[" + std::to_string(i) + "]"; };
  const auto command_field = [](std::size_t i) { return "commands[" + std::to_string(i) + "]"; };
  for (std::size_t i = 0; i < boxes.size(); ++i) validate_numbers(box_field(i), boxes[i]);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (const auto* insert = std::get_if<Insert<Real>>(&commands[i]))
      validate_numbers(command_field(i) + ".insert", insert->box);
    if (const auto* move = std::get_if<Move<Real>>(&commands[i]))
      validate_numbers(command_field(i) + ".box", move->box);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) validate_box(box_field(i), boxes[i]);
  validate.there.assign(boxes.size(), true);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    validate.field = command_field(i);
    std::visit([&validate](const auto& command) { validate(command); }, commands[i]);
  }
}

}  // namespace touchstone::validation
