// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/numbers/exact.h"
#include "catalogue/numbers/tracked.h"
#include "catalogue/numbers/true_number.h"
#include "catalogue/shape/shape.h"

/// Compares answers with the truth, slot by slot.
namespace touchstone::catalogue {

struct Comparison {
  bool decision = true;  ///< every enumerator is equal, and every required number is present
  bool finite = true;    ///< no NaN, and no infinity if the truth rounds to a finite number
  double ulps = 0;       ///< the greatest distance of a number
};

/// The parts that an answer may omit.
enum class Reading {
  complete,  ///< nothing
  less,      ///< what is optional
  partial,   ///< any number: the encoded value is one of a partial reading (catalogue/codec/shape_json.h)
};

Comparison compared(const Shape& shape, const EncodedTruth& truth, const EncodedValue<double>& answer, Reading reading,
                    bool binary32 = false);

/// The position of a number of an answer: among the truth's numbers, and among the answer's own.
struct PairedNumber {
  std::size_t in_truth, in_answer;
  Meaning meaning;
};
/// Every number of the truth that an answer has as well. Real: double or Tracked.
template <class Real>
std::vector<PairedNumber> paired_numbers(const Shape& shape, const EncodedTruth& truth,
                                         const EncodedValue<Real>& answer, Reading reading);

/// One of the innermost lists of an answer; each element is the indices that it holds: the pairs of one reply.
struct Listed {
  const char* name;   ///< of the member that it is; "" if none
  std::size_t width;  ///< enumerators of an element
  std::vector<std::vector<Word>> elements{};
};
/// The innermost lists of an answer without numbers, in order.
std::vector<Listed> listed(const Shape& shape, const std::vector<Word>& words);

/// Compares the elements of each innermost list regardless of order, both of the elements and within each; duplicates
/// are surplus. In a list of the name `in_order`, elements that must be removed for the others to be in the truth's
/// order also count as missing.
struct Covering {
  std::uint64_t missing = 0, surplus = 0;
};
Covering covered(const Shape& shape, const std::vector<Word>& truth, const std::vector<Word>& answer);

/// True if a formula run in exact arithmetic gave the truth: enumerators equal, numbers defined and equal.
bool same_as_truth(const Shape& shape, const EncodedTruth& truth, const EncodedValue<Exact>& answer, Reading reading);

/// Checks the promise of running error analysis: `plain` (run in double) is bit for bit equal to `tracked`, and within
/// its bound of `exact`. Call only if no comparison was uncertain.
bool promise_holds(const EncodedValue<double>& plain, const EncodedValue<Tracked>& tracked,
                   const EncodedValue<Exact>& exact);

/// The enumerators of an answer, in order ("hit", "convex/ccw"); "value" if there is none.
std::string outcome_of(const Shape& shape, const std::vector<Word>& words, bool partial = false);
/// The index of these among all possible ones; 0 if there are none.
std::size_t outcome_number(const Shape& shape, const std::vector<Word>& words);
/// Every enumerator that an answer can hold, without duplicates.
std::vector<std::string> words_of(const Shape& shape);
/// The first enumerator of that type in an answer.
std::optional<Word> word_in(const Shape& shape, const std::vector<Word>& words, const Shape& type);
/// The plain answer to "do they meet?" / "is it in the closed shape?"; nullopt if the operation has no such reading.
std::optional<bool> yes_or_no(const Shape& shape, const std::vector<Word>& words);
/// True if there is one.
bool has_plain_reading(const Shape& shape);

}  // namespace touchstone::catalogue
