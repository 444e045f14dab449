// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/codec/json.h"
#include "catalogue/families/choices.h"
#include "catalogue/judge/verdict.h"
#include "catalogue/scene.h"
#include "oracle/certificates/certificate.h"

namespace touchstone::audit {

/// How the answers of an operation are compared with the truth.
enum class Kind {
  decision,  ///< equal
  measure,   ///< numbers: distance from the exact value in units in the last place
  set,       ///< equal after canonical order
  checked,   ///< a checker accepts
  covering,  ///< nothing missing
};

/// What the catalogue says of an operation.
struct Card {
  const char* name;
  const char* chapter;
  const char* pages;     ///< of the deck
  const char* question;  ///< one plain sentence: what is asked
  Kind kind = Kind::decision;
  std::vector<const char*> fields{};  ///< names of the inputs in JSON, in order
  const char* answer = "";            ///< the answer's field name where the answer is one bare value
  double ulps = 0;                    ///< stated bound of the reference's numbers: roundings in the slide's formula
  int margin_degree = 1;              ///< the oracle's margin is a length to this power
  std::size_t list_length = 0;        ///< exhaustive runs: how many elements each list has, where there are lists
  /// The operation whose question this is, answered by another formula of the deck: this one is named "<operation>_<method>", has a
  /// reference of its own and the operation's robust and oracle, and is asked of no engine.
  const char* method_of = "";
  bool is_method() const { return method_of[0] != 0; }
  bool formula_answers_less =
      false;  ///< the slide's formula leaves out numbers that the operation answers, and is judged on the others
  std::size_t longest_vector =
      0;  ///< test vectors of more characters are left out: three coordinates of hundreds of digits each (0: none)
};

/// A question of any operation, its types forgotten: its numbers in canonical order (a list is preceded by its length).
struct Question {
  std::vector<double> numbers;
  friend bool operator==(const Question&, const Question&) = default;
};

/// One question with everything that can be said about it. Made by Operation::examine; computes lazily.
class Examination {
 public:
  virtual ~Examination() = default;

  virtual Json truth() const = 0;           ///< exact, "p/q"
  virtual Json rounded_truth() const = 0;   ///< every number the nearest double
  virtual std::string outcome() const = 0;  ///< the truth's word ("overlap"), or "value"
  virtual bool touch() const = 0;           ///< the truth is a touch: open and closed sets answer differently
  virtual mpq_class margin() const = 0;
  virtual oracle::Certificate certificate() const = 0;

  virtual Json reference(bool binary32 = false) const = 0;  ///< the slide's formula in double or float
  virtual Json robust() const = 0;

  virtual Judgement judge_reference(bool binary32 = false) const = 0;
  /// In that floating-point environment (see catalogue/judge/environment.h).
  virtual Judgement judge_robust(std::size_t environment) const = 0;
  Judgement judge_robust() const { return judge_robust(0); }
  /// `answer`: the engine's "answer" value: an object with the operation's fields, or true / false.
  virtual Judgement judge_engine(const Json& answer, const Declaration& declaration) const = 0;

  /// The contract's promise for the double version, tested: empty if it holds here. Where running error analysis proves
  /// that rounding cannot have changed a decision, reference in double must decide as in exact arithmetic, and its numbers must lie within
  /// the proved bound.
  virtual std::string broken_promise() const = 0;
};

/// Every decision on a range of a grid: robust against the oracle's integers, without numbers and certificates.
struct DecisionCount {
  std::uint64_t cases = 0, wrong = 0, hash = 0;  ///< hash: sum over the cases, so parts of a range add up
  std::map<std::string, std::uint64_t> outcomes;
  std::uint64_t first_wrong = 0;  ///< index of the first wrong case, if wrong > 0
};

/// One row of the catalogue, its types forgotten: all that the program, the tests and the fuzz targets need.
class Operation {
 public:
  virtual ~Operation() = default;

  virtual const Card& card() const = 0;
  std::string name() const { return card().name; }
  /// Every word that an answer can hold ("inside", "boundary" ...); none where answers are numbers alone.
  virtual std::vector<std::string> words() const = 0;

  /// Names of the input families, simplest first. Every name but the last few (drawn from the types alone) is a hard case of the operation;
  /// "x+ulp" is x with one coordinate moved by a few units in the last place.
  virtual const std::vector<std::string>& families() const = 0;
  virtual Question draw(Choices& choices, std::size_t family) const = 0;
  /// Every number 0; every list of that length.
  virtual Question zeros(std::size_t list_length) const = 0;
  /// Lists as long as in exhaustive runs.
  Question zeros() const { return zeros(card().list_length); }
  /// Where the coordinates stand in `Question::numbers`: everything but the lengths of lists.
  virtual std::vector<std::size_t> coordinates(const Question& question) const = 0;
  /// Every number rounded to the nearest float.
  virtual Question in_binary32(const Question& question) const = 0;

  virtual Question parse(const Json& input) const = 0;  ///< throws InvalidInput naming the field and the rule
  /// The same; "nan", "inf" and "-inf" are let through, for robust and oracle to refuse.
  virtual Question parse_any(const Json& input) const = 0;
  virtual Json print(const Question& question) const = 0;
  virtual Json print_hexadecimal(const Question& question) const = 0;

  /// Throws InvalidInput where the oracle refuses the question.
  virtual std::unique_ptr<Examination> examine(const Question& question) const = 0;
  /// Empty if robust and oracle both answer or both refuse with the same field and rule; else what differs.
  virtual std::string refusal_mismatch(const Question& question, std::size_t environment) const = 0;
  std::string refusal_mismatch(const Question& question) const { return refusal_mismatch(question, 0); }
  /// Truth for the decimals as typed, read as exact rationals.
  virtual Json truth_as_typed(const Json& input) const = 0;

  /// How many configurations such a grid has; empty beyond 2^64.
  std::optional<std::uint64_t> configurations(int size) const { return configurations(size, card().list_length); }
  std::optional<std::uint64_t> configurations(int size, std::size_t list_length) const;
  /// Configurations `first` <= index < `last` of the grid on which every number runs over 0 .. size - 1 (the first number is
  /// the slowest). Empty where the operation has no such fast pair of decisions.
  virtual std::optional<DecisionCount> count_decisions(int size, std::uint64_t first, std::uint64_t last) const = 0;
  /// The question of that index.
  Question on_grid(int size, std::uint64_t index) const { return on_grid(size, index, card().list_length); }
  Question on_grid(int size, std::uint64_t index, std::size_t list_length) const;

  /// The figure of a question and of the truth about it.
  virtual Scene scene(const Question& question) const = 0;
  /// For maps: indices of the two numbers to move, and a degenerate question around which to move them.
  virtual Question map_centre() const = 0;
  virtual std::pair<std::size_t, std::size_t> map_axes() const = 0;
};

/// The catalogue in the order of the deck.
const std::vector<const Operation*>& catalogue();
/// nullptr if there is none of that name.
const Operation* find_operation(const std::string& name);

}  // namespace touchstone::audit
