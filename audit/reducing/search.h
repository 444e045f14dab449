// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_set>

#include "audit/reducing/interest.h"
#include "audit/time_limit.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// True if the numbers and words of a question take fewer characters than those of another, then by `smaller`
/// (audit/counting/tally.h).
bool briefer(const Question& a, const Question& b);

/// True if a question is shorter than another: of ordinary magnitude if the other is not, then fewer elements in its
/// lists, then briefer. A total order without infinite descent.
bool shorter(const Operation& operation, const Question& a, const Question& b);

/// The options of a search.
struct SearchOptions {
  int jobs = 1;
  TimeLimit limit{};
  const std::atomic<bool>* stop = nullptr;          ///< ends the search once it is true
  std::function<void(const Question&)> progress{};  ///< called with each shorter question
  /// A question may get degenerate features (audit/counting/generic.h) that the first one lacks. A reader takes them
  /// for the cause.
  bool allow_degenerate = false;
};

/// The shortest question so far with the property, and the search for shorter ones. The result depends neither on the
/// jobs nor on their speed, unless it is ended early.
class Search {
 public:
  /// Starts from a question with the property.
  Search(const Operation& operation, Question question, Interest& interest, const SearchOptions& options);

  const Operation& operation() const { return operation_; }
  const Question& best() const { return best_; }
  std::uint64_t candidates() const { return candidates_; }  ///< examined, each once
  bool over() const;

  /// Makes the candidate of that number, or nullopt.
  using Make = std::function<std::optional<Question>(std::size_t)>;
  /// Finds the first of `count` candidates that is shorter than the best and has the property; it becomes the best.
  /// Several jobs examine several candidates, of which the first in order counts.
  std::optional<std::size_t> first(std::size_t count, const Make& make);
  /// True if a candidate examined in the last call was within the contract.
  bool any_within() const { return looked_ > refused_; }
  /// True if a question has the property, whether shorter or not.
  bool holds(const Question& question);

 private:
  struct Looked {
    std::optional<Question> question{};  ///< nullopt: not shorter, or examined before
    std::uint64_t hash = 0;
    Look look = Look::fails;
  };
  Looked reviewed(std::size_t job, std::optional<Question> candidate) const;

  const Operation& operation_;
  Interest& interest_;
  SearchOptions options_;
  Question best_;
  std::size_t most_features_;
  std::unordered_set<std::uint64_t> failed_;
  std::uint64_t candidates_ = 0, looked_ = 0, refused_ = 0;
};

}  // namespace touchstone::audit
