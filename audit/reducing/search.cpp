// SPDX-License-Identifier: Apache-2.0
#include "audit/reducing/search.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>
#include <vector>

#include "audit/counting/generic.h"
#include "audit/counting/tally.h"
#include "audit/parallel.h"

namespace touchstone::audit {
namespace {

/// FNV-1a over the bits of a question. Two with the same hash by chance cost one candidate.
std::uint64_t hash_of(const Question& question) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&hash](std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash = (hash ^ (bits & 0xff)) * 0x100000001b3;
  };
  for (const double number : question.numbers) add(std::bit_cast<std::uint64_t>(number));
  for (const Word word : question.words) add(word);
  return hash;
}

std::size_t characters_of(const Question& question) {
  std::size_t characters = 0;
  char text[40];
  for (const double number : question.numbers)
    characters += static_cast<std::size_t>(std::to_chars(text, text + sizeof text, number).ptr - text);
  for (const Word word : question.words)
    characters += static_cast<std::size_t>(std::to_chars(text, text + sizeof text, word).ptr - text);
  return characters;
}

}  // namespace

bool briefer(const Question& a, const Question& b) {
  const std::size_t characters_a = characters_of(a), characters_b = characters_of(b);
  return characters_a != characters_b ? characters_a < characters_b : smaller(a, b);
}

bool shorter(const Operation& operation, const Question& a, const Question& b) {
  const Range range_a = range_of(a), range_b = range_of(b);
  if (range_a != range_b) return range_a < range_b;
  const Word elements_a = elements_of_lists(*operation.row().question, a),
             elements_b = elements_of_lists(*operation.row().question, b);
  return elements_a != elements_b ? elements_a < elements_b : briefer(a, b);
}

Search::Search(const Operation& operation, Question question, Interest& interest, const SearchOptions& options)
    : operation_(operation),
      interest_(interest),
      options_(options),
      best_(std::move(question)),
      most_features_(options.allow_degenerate ? std::numeric_limits<std::size_t>::max()
                                              : degenerate_features(operation, best_, false)) {}

bool Search::over() const { return options_.limit.over() || (options_.stop != nullptr && *options_.stop); }

Search::Looked Search::reviewed(std::size_t job, std::optional<Question> candidate) const {
  Looked looked;
  if (!candidate) return looked;
  Question question = interest_.fitted(*candidate);
  if (!shorter(operation_, question, best_)) return looked;
  looked.hash = hash_of(question);
  if (failed_.count(looked.hash) > 0) return looked;
  if (!options_.allow_degenerate && degenerate_features(operation_, question, false) > most_features_) return looked;
  looked.look = interest_.look(job, question);
  looked.question = std::move(question);
  return looked;
}

std::optional<std::size_t> Search::first(std::size_t count, const Make& make) {
  looked_ = refused_ = 0;
  const auto jobs = static_cast<std::size_t>(std::max(options_.jobs, 1));
  for (std::size_t begin = 0; begin < count && !over(); begin += jobs) {
    std::vector<Looked> batch(std::min(jobs, count - begin));
    in_parallel(options_.jobs, batch.size(), [&](std::size_t i) { batch[i] = reviewed(i, make(begin + i)); });
    if (over()) break;  // an interrupted engine has said nothing
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (!batch[i].question || failed_.count(batch[i].hash) > 0) continue;
      ++candidates_, ++looked_;
      refused_ += batch[i].look == Look::refused;
      if (batch[i].look != Look::holds) {
        failed_.insert(batch[i].hash);
        continue;
      }
      best_ = *std::move(batch[i].question);
      interest_.go_on_with(best_);
      if (options_.progress) options_.progress(best_);
      return begin + i;
    }
  }
  return std::nullopt;
}

bool Search::holds(const Question& question) {
  ++candidates_;
  return interest_.look(0, interest_.fitted(question)) == Look::holds;
}

}  // namespace touchstone::audit
