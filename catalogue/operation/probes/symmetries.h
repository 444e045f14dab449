// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "catalogue/operation/operation.h"

/// The symmetries that rows declare (catalogue/operation/laws.h), applied to any implementation.
namespace touchstone::catalogue {

/// Answers a question, or throws InvalidInput if it is outside the contract.
template <class Real>
using Answering = std::function<EncodedValue<Real>(const Question&)>;

/// The part of two answers that has to be the same.
enum class Compared {
  everything,  ///< for what answers exactly or rounds correctly
  decisions,   ///< enumerators alone: numbers that round differently in an image are not a defect
};

bool declares_laws(const Operation& operation);

/// The law that is broken for a question: "arguments exchanged", "times a power of two", "a symmetry of the axes", "an
/// integer similarity", "an integer map"; "" if none is, or if the question is refused. `answer` is the shape of
/// `ask`'s result: that of the operation's answers, or of their enumerator alone.
std::string broken_law(const Operation& operation, const Question& question, const Answering<double>& ask,
                       const Shape& answer, Compared compared);
/// The same for exact answers to the operation.
std::string broken_law(const Operation& operation, const Question& question, const Answering<TrueNumber>& ask);

}  // namespace touchstone::catalogue
