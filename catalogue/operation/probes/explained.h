// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// Operation, input, truth and margin: what `ask --truth` prints. Neither certificate nor robust nor a formula is
/// evaluated for it.
Json truth_alone(const Examination& examination);

/// Everything that can be said of one question without an engine: what `ask` prints. The textbook formula, and the
/// cause of its error, only where they take few steps for as many elements as the question's lists have
/// (Metadata::time).
Json explained(const Examination& examination);

Json certificate_json(const oracle::Certificate& certificate);

/// An answer and the verdict on it.
Json verdict_json(const Judgement& judgement, Json answer);

/// What the checker of certificates reads of a question: operation, input, truth and certificate.
nlohmann::json claim_of(const Examination& examination);

/// What the checker says against the oracle's certificate; empty if it accepts it.
std::string certificate_complaint(const Examination& examination);

/// The truth for the decimals of an input that was printed, read as exact rationals; null where the operation has none.
Json truth_of_decimals(const Operation& operation, const Json& printed);

}  // namespace touchstone::catalogue
