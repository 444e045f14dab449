// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "catalogue/operation/operation.h"

/// The symmetries that rows declare (catalogue/operation/laws.h), asked of anything that answers.
namespace touchstone::catalogue {

/// Answers a question, or throws InvalidInput where it is outside the contract.
template <class Real>
using Answering = std::function<EncodedValue<Real>(const Question&)>;

/// What of two answers has to be the same.
enum class Compared {
  everything,  ///< for what answers exactly or rounds correctly
  decisions,   ///< words alone: numbers that round differently in an image are no defect
};

bool declares_laws(const Operation& operation);

/// The law that is broken for a question: "arguments exchanged", "times a power of two", "a symmetry of the axes", "an
/// integer similarity", "an integer map"; "" where none is, or the question is refused. `answer` is the shape of what
/// `ask` returns: that of the operation's answers, or of their word alone.
std::string broken_law(const Operation& operation, const Question& question, const Answering<double>& ask,
                       const Shape& answer, Compared compared);
/// The same of exact answers to the operation.
std::string broken_law(const Operation& operation, const Question& question, const Answering<TrueNumber>& ask);

}  // namespace touchstone::catalogue
