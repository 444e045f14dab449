// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <concepts>
#include <optional>

namespace touchstone::oracle {

/// Every number of the oracle: an exact rational, canonical. (Never `auto` on an expression of these.)
using Rational = mpq_class;

/// Every operation takes doubles, and rationals too: a template that deduces them, so that braces mean doubles.
template <class Number>
concept Exact = std::same_as<Number, Rational>;

/// The one right answer and the margin: how far the input is, along the deciding quantity of the operation (named in
/// the operation's own header), from the nearest change of answer. 0 for a degenerate input, never negative; none where
/// no other answer exists, or nothing is decided.
template <class Answer>
struct Truth {
  Answer answer;
  std::optional<Rational> margin;
};

}  // namespace touchstone::oracle
