// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace touchstone {

/// Input outside the contract: thrown by `robust` and `oracle` in every build type. Names the field as it is written in
/// JSON ("a[0][1]", "ray.direction") and the rule that it breaks ("finite number").
class InvalidInput : public std::invalid_argument {
 public:
  InvalidInput(std::string field, std::string rule)
      : std::invalid_argument(field + ": " + rule), field_(std::move(field)), rule_(std::move(rule)) {}
  const std::string& field() const noexcept { return field_; }
  const std::string& rule() const noexcept { return rule_; }

 private:
  std::string field_, rule_;
};

}  // namespace touchstone
