// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/codec/shape_json.h"
#include "catalogue/judge/compare.h"
#include "catalogue/operation/examination.h"
#include "catalogue/operation/families.h"
#include "catalogue/operation/row_functions.h"

namespace touchstone::catalogue {

/// One operation of the catalogue: everything that the program, the tests and the fuzz target need, as ordinary
/// functions over its row.
class Operation {
 public:
  explicit Operation(RowFunctions functions);
  Operation(const Operation&) = delete;
  Operation& operator=(const Operation&) = delete;

  const Metadata& metadata() const { return *row_.metadata; }
  std::string name() const { return metadata().name; }
  const RowFunctions& row() const { return row_; }
  /// The shape of its questions, with the names of the fields, and of its answers.
  const Shape& question_shape() const { return question_; }
  const Shape& answer_shape() const { return *row_.answer; }
  /// Every enumerator that an answer can hold ("inside", "boundary" ...); none if answers are numbers alone.
  std::vector<std::string> words() const { return words_of(*row_.answer); }
  /// The names of the fields of an alternative of its questions.
  const FieldNames& fields(std::size_t alternative = 0) const;

  /// Names of the input families, simplest first. Every name but the last few (drawn from the types alone) is a hard
  /// case of the operation; "x+ulp" is x with one coordinate moved by a few units in the last place.
  const std::vector<std::string>& families() const { return families_.names(); }
  Question draw(DrawStream& draws, std::size_t family) const { return families_.draw(draws, family); }
  /// Every number and every enumerator 0; every list of that length; that alternative.
  Question zeros(std::size_t list_length, std::size_t alternative = 0) const;
  /// With lists as long as in exhaustive runs.
  Question zeros() const { return zeros(metadata().list_length); }
  /// One for each alternative; a single one if there are none.
  std::vector<Question> zeros_of_alternatives(std::size_t list_length) const;
  std::vector<Question> zeros_of_alternatives() const { return zeros_of_alternatives(metadata().list_length); }
  /// Every number rounded to the nearest float.
  Question in_binary32(const Question& question) const;

  Question parse(const Json& input) const;  ///< throws InvalidInput naming the field and the rule
  /// The same; accepts "nan", "inf" and "-inf", for robust and oracle to refuse.
  Question parse_any(const Json& input) const;
  Json print(const Question& question) const;
  Json print_hexadecimal(const Question& question) const;

  /// An answer as JSON, under its field's name if it is one bare value.
  Json answer_json(const EncodedValue<double>& answer) const;
  Json answer_json(const EncodedTruth& answer) const;

  /// The shape of an answer: {"relation": "on | off", "t?": "number"}.
  Json answer_description() const { return named(json_of(*row_.answer)); }

  /// The same for a question, by field; a list of these if there are alternatives.
  Json question_description() const;

  /// Throws InvalidInput if the oracle refuses the question.
  std::unique_ptr<Examination> examine(const Question& question) const;
  /// Returns "" if robust and oracle both answer or both refuse with the same field and rule; otherwise the difference.
  std::string refusal_mismatch(const Question& question, std::size_t environment = 0) const;
  /// The truth for the decimals as typed, parsed as exact rationals.
  Json truth_as_typed(const Json& input) const;

  /// The number of configurations of such a grid; nullopt beyond 2^64.
  std::optional<std::uint64_t> configurations(int size) const { return configurations(size, metadata().list_length); }
  std::optional<std::uint64_t> configurations(int size, std::size_t list_length) const;
  /// The same if every number runs over all of 0 .. size - 1, whatever domain the row has.
  std::optional<std::uint64_t> configurations_of_plain_grid(int size, std::size_t list_length) const;
  /// The question of that index. On a plain grid every number runs over 0 .. size - 1 and every enumerator over all its
  /// values; the first number is the slowest, enumerators are faster than numbers, and alternatives follow one another.
  Question on_grid(int size, std::uint64_t index) const { return on_grid(size, index, metadata().list_length); }
  Question on_grid(int size, std::uint64_t index, std::size_t list_length) const;
  /// Decides the configurations `first` <= index < `last` of that grid, decisions alone. nullopt if the operation has
  /// no such fast pair of decisions.
  std::optional<DecisionCount> count_decisions(int size, std::uint64_t first, std::uint64_t last) const {
    return count_decisions(size, first, last, metadata().list_length);
  }
  std::optional<DecisionCount> count_decisions(int size, std::uint64_t first, std::uint64_t last,
                                               std::size_t list_length) const;

  /// For maps: the indices of the two numbers to vary, and a degenerate question around which to vary them.
  Question map_centre() const;
  std::pair<std::size_t, std::size_t> map_axes() const;

 private:
  template <class Real>
  EncodedValue<Real> read(const Json& input, ReadNumber<Real> read_number) const;
  Json named(Json bare) const;

  RowFunctions row_;
  std::vector<Shape> alternatives_;
  Shape question_;
  Families families_;
};

/// The catalogue in the order of the deck.
const std::vector<const Operation*>& all_operations();
/// Returns nullptr if no operation has that name.
const Operation* find_operation(const std::string& name);

}  // namespace touchstone::catalogue
