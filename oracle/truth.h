// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::oracle {

/// Every number of the oracle: an exact rational, canonical. (Never `auto` on an expression of these.)
using Rational = mpq_class;

/// Every operation takes doubles, and rationals too: `template <Exact Number = double>`, so that braces mean doubles.
template <class Number>
concept Exact = std::same_as<Number, double> || std::same_as<Number, Rational>;

/// A proof of one answer in named lists of rationals, for a checker that knows no geometry algorithm: it only
/// multiplies, adds and compares. `kind` determines which inequalities must hold; each kind is described where it is
/// checked.
struct Certificate {
  std::string kind;
  std::vector<std::pair<std::string, std::vector<Rational>>> facts;
  /// Proofs of parts of the claim, by name: a certificate is a tree.
  std::vector<std::pair<std::string, std::vector<Certificate>>> parts{};
};

/// The right answer and the margin: the distance of the input, along the deciding quantity of the operation (named in
/// the operation's own header), from the nearest change of answer. 0 for a degenerate input, never negative; none if no
/// other answer exists, or nothing is decided.
template <class Answer>
struct Truth {
  Answer answer;
  std::optional<Rational> margin;
  /// Makes the certificate from the results of the solution, which it keeps. Overloads for rationals may leave it
  /// empty: certificates are for doubles.
  std::function<Certificate()> certificate{};
};

}  // namespace touchstone::oracle
