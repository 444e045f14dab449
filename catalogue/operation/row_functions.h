// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/draw/drawing.h"
#include "catalogue/families/draw_stream.h"
#include "catalogue/judge/excess.h"
#include "catalogue/numbers/exact.h"
#include "catalogue/numbers/tracked.h"
#include "catalogue/numbers/true_number.h"
#include "catalogue/operation/laws.h"
#include "catalogue/operation/metadata.h"
#include "catalogue/shape/shape.h"
#include "oracle/truth.h"
#include "robust/batch/isa/columns.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::catalogue {

/// The oracle's answer to a question.
struct Solution {
  EncodedTruth answer;
  std::optional<mpq_class> margin;  ///< if the operation decides something
  std::function<oracle::Certificate()> certificate{};
};

/// Every decision on a range of a grid: robust against the oracle's integers, without numbers and certificates.
struct DecisionCount {
  std::uint64_t cases = 0, wrong = 0, hash = 0;  ///< hash: sum over the cases, so parts of a range add up
  std::map<std::string, std::uint64_t> outcomes;
  std::map<std::string, std::uint64_t> of_grid;  ///< of all configurations that the cases represent; otherwise empty
  std::uint64_t first_wrong = 0;                 ///< index of the first wrong case, if wrong > 0
};

/// The questions of an exhaustive run, if a plain grid of numbers would be too large or mostly invalid.
struct SmallDomain {
  std::uint64_t (*count)(int size);
  Question (*at)(int size, std::uint64_t index);
};

/// The stages of an answer or of a decision alone (robust/kernel/filters/staged.h). For valid questions only.
struct StageFunctions {
  struct One {
    robust::Stage stage;
    std::optional<EncodedValue<double>> (*ask)(const Question&, std::size_t environment);  ///< nullopt: undecided
  };
  std::vector<One> each;  ///< in the order in which they are tried
  robust::Stage (*decided_by)(const Question&, std::size_t environment) = nullptr;  ///< nullptr: robust does not say
};

/// Decisions over arrays (robust/batch/isa/columns.h): enumerators, one byte each.
struct ArrayFunctions {
  /// For `count` questions, all like `shared` except for the numbers that have columns. nullptr: robust does not answer
  /// arrays.
  void (*decide)(const Question& shared, const robust::batch::Column* columns, std::size_t count, std::uint8_t* answers,
                 robust::batch::Instructions at_most) = nullptr;
  /// The numbers of a question that have columns, in their order.
  std::vector<std::size_t> (*columns)(const Question&) = nullptr;
};

/// The result of a formula under running error analysis.
inline EncodedValue<double> in_doubles(const EncodedValue<Tracked>& formula) {
  return encoded_with<double>(formula, [](const Tracked& number) { return number.value(); });
}

/// A formula for an operation under running error analysis, in double or, where `binary32`, in float.
/// Tracked::inconclusive() is not reset.
struct TrackedFormula {
  const char* name;
  EncodedValue<Tracked> (*ask)(const Question&, bool binary32);
};

/// A row of the catalogue with its types erased (catalogue/operation/row_of.h makes it): the functions of the three
/// modules over encoded values, and the row's own functions. Members that may be nullptr say so.
struct RowFunctions {
  const Metadata* metadata;
  const Shape* question;
  const Shape* answer;

  /// The formula of the deck.
  EncodedValue<double> (*reference)(const Question&);
  EncodedValue<Exact> (*reference_exactly)(const Question&);
  TrackedFormula reference_tracked;
  /// Other textbook formulas for the same question (reference/standard/), for which an engine is not blamed either.
  std::vector<TrackedFormula> standard;

  /// In that floating-point environment (catalogue/judge/environment.h).
  EncodedValue<double> (*robust)(const Question&, std::size_t environment);
  /// The same by shapes that are validated once (robust/prepared); nullptr: robust takes none.
  EncodedValue<double> (*prepared)(const Question&, std::size_t environment) = nullptr;
  Solution (*solve)(const Question&);
  Solution (*solve_as_typed)(const EncodedValue<mpq_class>&);  ///< nullptr: there is no exact answer to decimals

  /// Decisions alone; `decision` is the shape of the enumerator, nullptr if robust has no function for it.
  const Shape* decision;
  Word (*decide)(const Question&, std::size_t environment);
  Word (*decide_by_oracle)(const Question&);    ///< nullptr: the oracle has no quick decision
  Word (*decide_by_integers)(const Question&);  ///< for small integers; nullptr likewise
  DecisionCount (*count_decisions)(int size, std::uint64_t first, std::uint64_t last,
                                   std::size_t list_length);  ///< nullptr likewise

  ArrayFunctions batch;

  StageFunctions stages, decision_stages;

  /// Hard cases in the order of the row.
  struct HardCaseName {
    std::string name;
    bool unscaled;  ///< as in HardCase
  };
  std::vector<HardCaseName> hard_cases;
  Question (*draw_hard_case)(std::size_t which, DrawStream&);

  // Hooks of the row; nullptr if it has none.
  std::optional<EncodedTruth> (*as_open_sets)(const EncodedTruth& truth, const Question&);
  std::string (*defect)(const Question&, const EncodedValue<double>& answer);
  std::string (*exact_defect)(const Question&, const EncodedValue<mpq_class>& answer);
  Excess (*excess)(const Question&, const EncodedValue<double>& answer, const EncodedValue<double>& truth);
  std::optional<EncodedTruth> (*as_near)(const Question&, const EncodedTruth& truth,
                                         const EncodedValue<double>& answer);
  void (*repair)(Question&);
  void (*scale)(Question&, int exponent);
  std::vector<std::uint64_t> (*places)(const Question&);
  std::vector<mpq_class> (*residuals)(const Question&, const EncodedValue<double>& answer);
  Question (*map_centre)();
  std::pair<std::size_t, std::size_t> (*map_axes)();
  void (*draw)(Drawing&, const Question&, const EncodedValue<double>& truth);  ///< the truth in nearest doubles
  std::optional<SmallDomain> world;
  Laws laws;
};

}  // namespace touchstone::catalogue
