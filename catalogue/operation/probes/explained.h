// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// Operation, input, truth and margin: the output of `ask --truth`. Evaluates neither the certificate nor robust nor a
/// formula.
Json truth_alone(const Examination& examination);

/// Everything that is known about one question without an engine: the output of `ask`. Includes the textbook formula,
/// and the cause of its error, only if they take few steps for the number of elements in the question's lists
/// (Metadata::time).
Json explained(const Examination& examination);

/// The steps of the textbook formula, in words, if they are too many for the cause of an error to be sought, and for
/// the formula to be evaluated in float, which takes an error analysis of each step; "" otherwise.
std::string too_many_for_a_cause(const Examination& examination);

Json certificate_json(const oracle::Certificate& certificate);

/// An answer and the verdict on it.
Json verdict_json(const Judgement& judgement, Json answer);

/// The input of the checker of certificates: operation, input, truth and certificate.
nlohmann::json claim_of(const Examination& examination);

/// The checker's complaint about the oracle's certificate; "" if it accepts it.
std::string certificate_complaint(const Examination& examination);

/// The truth for the decimals of a printed input, parsed as exact rationals; null if the operation has none.
Json truth_of_decimals(const Operation& operation, const Json& printed);

}  // namespace touchstone::catalogue
