// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "catalogue/operation/row_functions.h"

namespace touchstone::catalogue {

/// The families of inputs of an operation: its hard cases, most of them also moved by an ulp, and those that follow
/// from its types.
class Families {
 public:
  /// Throws std::logic_error if two have one name: questions are drawn and asked for by names.
  explicit Families(const RowFunctions& row);

  const std::vector<std::string>& names() const { return names_; }
  Question draw(DrawStream& draws, std::size_t family) const;

 private:
  const RowFunctions& row_;
  std::vector<std::string> names_;
  std::vector<std::size_t> moved_;  ///< the hard cases with families "+ulp"
};

}  // namespace touchstone::catalogue
