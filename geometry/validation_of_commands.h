// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"

/// Validation of programs, for doubles and for rationals alike: see validation.h.
namespace touchstone::validation {

/// First all numbers, then the rules of the boxes in their order, then those of the commands; of a command its body
/// before its box. `validate_numbers(field, shape)` and `validate_shape(field, shape)` hold those of a box, a point or
/// a ray.
template <class Real, class ValidateNumbers, class ValidateShape>
void validate_program(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands,
                      const ValidateNumbers& validate_numbers, const ValidateShape& validate_shape) {
  struct Numbers {
    const ValidateNumbers& validate_numbers;
    std::string field{};

    void operator()(const Insert<Real>& command) const { validate_numbers(field + ".insert", command.box); }
    void operator()(const Move<Real>& command) const { validate_numbers(field + ".box", command.box); }
    void operator()(const Remove&) const {}
    void operator()(const Ask&) const {}
    void operator()(const InBox<Real>& query) const { validate_numbers(field + ".in_box", query.box); }
    void operator()(const AtPoint<Real>& query) const { validate_numbers(field + ".at_point", query.point); }
    void operator()(const AlongRay<Real>& query) const { validate_numbers(field + ".along_ray", query.ray); }
  } numbers{validate_numbers};
  struct Rules {
    const ValidateShape& validate_shape;
    std::vector<bool> there{};
    std::string field{};

    void require(Index body, const char* member) const {
      if (body >= there.size() || !there[body]) throw InvalidInput(field + member, "index of a body that is there");
    }
    void operator()(const Insert<Real>& command) {
      validate_shape(field + ".insert", command.box);
      there.push_back(true);
    }
    void operator()(const Move<Real>& command) {
      require(command.body, ".move");
      validate_shape(field + ".box", command.box);
    }
    void operator()(const Remove& command) {
      require(command.body, ".remove");
      there[command.body] = false;
    }
    void operator()(const Ask&) const {}
    void operator()(const InBox<Real>& query) const { validate_shape(field + ".in_box", query.box); }
    void operator()(const AtPoint<Real>& query) const { validate_shape(field + ".at_point", query.point); }
    void operator()(const AlongRay<Real>& query) const { validate_shape(field + ".along_ray", query.ray); }
  } rules{validate_shape};
  const auto box_field = [](std::size_t i) { return "boxes[" + std::to_string(i) + "]"; };
  const auto each_command = [&commands](auto& validate) {
    for (std::size_t i = 0; i < commands.size(); ++i) {
      validate.field = "commands[" + std::to_string(i) + "]";
      std::visit([&validate](const auto& command) { validate(command); }, commands[i]);
    }
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) validate_numbers(box_field(i), boxes[i]);
  each_command(numbers);
  for (std::size_t i = 0; i < boxes.size(); ++i) validate_shape(box_field(i), boxes[i]);
  rules.there.assign(boxes.size(), true);
  each_command(rules);
}

}  // namespace touchstone::validation
