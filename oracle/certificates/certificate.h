// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "oracle/truth.h"

namespace touchstone::oracle {

/// A proof of one answer in named lists of rationals, for a checker that knows no geometry algorithm: it only
/// multiplies, adds and compares. `kind` says which inequalities are to hold; each kind is described where it is
/// checked.
struct Certificate {
  std::string kind;
  std::vector<std::pair<std::string, std::vector<Rational>>> facts;
  /// Proofs of parts of the claim, by name: a certificate is a tree.
  std::vector<std::pair<std::string, std::vector<Certificate>>> parts{};
};

}  // namespace touchstone::oracle
