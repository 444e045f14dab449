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

/// Whether the numbers and words of a question take fewer characters than those of another, then `smaller`
/// (audit/counting/tally.h).
bool briefer(const Question& a, const Question& b);

/// Whether a question is shorter than another: of ordinary size where the other is not, then fewer elements in its
/// lists, then briefer. A total order without infinite descent.
bool shorter(const Operation& operation, const Question& a, const Question& b);

/// How a search is run.
struct SearchOptions {
  int jobs = 1;
  TimeLimit limit{};
  const std::atomic<bool>* stop = nullptr;          ///< ends the search once it is true
  std::function<void(const Question&)> progress{};  ///< hears each question that is shorter
  /// A question may get degenerate features (audit/counting/generic.h) that the first one has not. A reader takes them
  /// for the cause.
  bool allow_degenerate = false;
};

/// The shortest question so far that holds, and the search for shorter ones. What it finds depends neither on the jobs
/// nor on how fast they are, unless it is ended early.
class Search {
 public:
  /// Of a question that holds.
  Search(const Operation& operation, Question question, Interest& interest, const SearchOptions& options);

  const Operation& operation() const { return operation_; }
  const Question& best() const { return best_; }
  std::uint64_t candidates() const { return candidates_; }  ///< that were looked at, each once
  bool over() const;

  /// Makes the candidate of that number, or none.
  using Make = std::function<std::optional<Question>(std::size_t)>;
  /// Looks for the first of so many candidates that is shorter than the best and holds; it is the best from then on.
  /// Several jobs look at several candidates, of which the first in order counts.
  std::optional<std::size_t> first(std::size_t count, const Make& make);
  /// Whether a candidate of the last call that was looked at was within the contract.
  bool any_within() const { return looked_ > refused_; }
  /// Whether a question holds, be it shorter or not.
  bool holds(const Question& question);

 private:
  struct Looked {
    std::optional<Question> question{};  ///< nothing: not shorter, or looked at before
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
