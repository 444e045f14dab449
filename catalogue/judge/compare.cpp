// SPDX-License-Identifier: Apache-2.0
#include "catalogue/judge/compare.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>

#include "catalogue/numbers/lexicographic.h"
#include "catalogue/numbers/true_number.h"
#include "catalogue/numbers/ulps.h"

namespace touchstone::catalogue {
namespace {

/// Moves past a value.
template <class At>
void skip(const Shape& shape, At& at, bool partial = false) {
  switch (shape.kind) {
    case Shape::Kind::number:
      if (!partial || *at.word++ != 0) ++at.number;
      return;
    case Shape::Kind::word:
    case Shape::Kind::flag:
    case Shape::Kind::index: ++at.word; return;
    case Shape::Kind::optional:
      if (*at.word++ != 0) skip(*shape.parts[0].shape, at, partial);
      return;
    case Shape::Kind::list:
      for (Word left = *at.word++; left > 0; --left) skip(*shape.parts[0].shape, at, partial);
      return;
    case Shape::Kind::choice: {
      const Word which = *at.word++;
      return skip(*shape.parts[which].shape, at, partial);
    }
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) skip(*part.shape, at, partial);
  }
}

/// Traverses truth and answer together. OnWord(truth, answer) compares enumerators, OnNumber(truth, answer, meaning)
/// numbers.
template <class Real>
class SideBySide {
 public:
  SideBySide(const EncodedTruth& truth, const EncodedValue<Real>& answer, Reading reading)
      : truth_(truth), answer_(answer), reading_(reading) {}

  template <class OnNumber>
  bool walk(const Shape& shape, const OnNumber& on_number) {
    switch (shape.kind) {
      case Shape::Kind::number: {
        const bool there = reading_ != Reading::partial || *answer_.word++ != 0;
        if (there) on_number(*truth_.number, *answer_.number++, shape.meaning);
        ++truth_.number;
        return true;
      }
      case Shape::Kind::word:
      case Shape::Kind::flag:
      case Shape::Kind::index: return *truth_.word++ == *answer_.word++;
      case Shape::Kind::optional: return walk_optional(*shape.parts[0].shape, on_number);
      case Shape::Kind::list: return walk_list(*shape.parts[0].shape, on_number);
      case Shape::Kind::choice: {
        const Word truth = *truth_.word++, answer = *answer_.word++;
        if (truth == answer) return walk(*shape.parts[truth].shape, on_number);
        skip(*shape.parts[truth].shape, truth_), skip(*shape.parts[answer].shape, answer_, partial());
        return false;
      }
      case Shape::Kind::record: break;
    }
    bool same = true;
    for (const Shape::Part& part : shape.parts) same = walk(*part.shape, on_number) && same;
    return same;
  }

 private:
  bool partial() const { return reading_ == Reading::partial; }

  template <class OnNumber>
  bool walk_optional(const Shape& part, const OnNumber& on_number) {
    const bool in_truth = *truth_.word++ != 0, in_answer = *answer_.word++ != 0;
    if (in_truth && in_answer) return walk(part, on_number);
    if (in_truth) skip(part, truth_);
    if (in_answer) skip(part, answer_, partial());
    return in_truth == in_answer || reading_ != Reading::complete;
  }

  template <class OnNumber>
  bool walk_list(const Shape& part, const OnNumber& on_number) {
    const Word in_truth = *truth_.word++, in_answer = *answer_.word++;
    bool same = in_truth == in_answer;
    for (Word i = 0; i < std::min(in_truth, in_answer); ++i) same = walk(part, on_number) && same;
    for (Word i = in_answer; i < in_truth; ++i) skip(part, truth_);
    for (Word i = in_truth; i < in_answer; ++i) skip(part, answer_, partial());
    return same;
  }

  Cursor<TrueNumber> truth_;
  Cursor<Real> answer_;
  Reading reading_;
};

/// A cursor over enumerators alone.
struct WordCursor {
  struct {
    void operator++() {}
  } number;
  const Word* word;
};

/// Calls visit(shape, word) for every enumerator that is not part of an optional or of a list.
template <class Visit>
void for_each_word(const Shape& shape, WordCursor& at, bool partial, const Visit& visit) {
  if (shape.kind == Shape::Kind::word) return visit(shape, *at.word++);
  if (shape.kind != Shape::Kind::record) return skip(shape, at, partial);
  for (const Shape::Part& part : shape.parts) for_each_word(*part.shape, at, partial, visit);
}

void for_each_word_shape(const Shape& shape, const std::function<void(const Shape&)>& visit) {
  if (shape.kind == Shape::Kind::word) visit(shape);
  if (shape.kind != Shape::Kind::record) return;
  for (const Shape::Part& part : shape.parts) for_each_word_shape(*part.shape, visit);
}

}  // namespace

Comparison compared(const Shape& shape, const EncodedTruth& truth, const EncodedValue<double>& answer, Reading reading,
                    bool binary32) {
  Comparison result;
  SideBySide<double> both(truth, answer, reading);
  result.decision = both.walk(shape, [&](const TrueNumber& right, double answered, Meaning) {
    const double ulps = distance_in_ulps(answered, right, binary32);
    if (std::isinf(ulps)) result.finite = false;
    result.ulps = std::max(result.ulps, ulps);
  });
  return result;
}

template <class Real>
std::vector<PairedNumber> paired_numbers(const Shape& shape, const EncodedTruth& truth,
                                         const EncodedValue<Real>& answer, Reading reading) {
  std::vector<PairedNumber> pairs;
  SideBySide<Real> both(truth, answer, reading);
  both.walk(shape, [&](const TrueNumber& right, const Real& answered, Meaning meaning) {
    pairs.push_back({static_cast<std::size_t>(&right - truth.numbers.data()),
                     static_cast<std::size_t>(&answered - answer.numbers.data()), meaning});
  });
  return pairs;
}
template std::vector<PairedNumber> paired_numbers(const Shape&, const EncodedTruth&, const EncodedValue<double>&,
                                                  Reading);
template std::vector<PairedNumber> paired_numbers(const Shape&, const EncodedTruth&, const EncodedValue<Tracked>&,
                                                  Reading);

namespace {

void collect(const Shape& shape, const char* name, const Word*& at, std::vector<Listed>& lists) {
  if (shape.kind == Shape::Kind::choice) {
    const Word which = *at++;
    return collect(*shape.parts[which].shape, name, at, lists);
  }
  if (shape.kind != Shape::Kind::list) {
    for (const Shape::Part& part : shape.parts) collect(*part.shape, part.name, at, lists);
    return;
  }
  const Shape& element = *shape.parts[0].shape;
  const Word length = *at++;
  if (element.fixed) lists.push_back({name, element.word_count});
  for (Word i = 0; i < length; ++i) {
    if (!element.fixed) {
      collect(element, "", at, lists);
      continue;
    }
    lists.back().elements.emplace_back(at, at + element.word_count);
    at += element.word_count;
  }
}

/// The number of elements of the first list, which has no duplicates, that must be removed for the others to be in the
/// second one in this order: all but the longest increasing subsequence of their first positions there.
std::uint64_t out_of_order(const Listed& right, const Listed& said) {
  std::map<std::vector<Word>, std::size_t, Lexicographic> first;
  for (std::size_t i = 0; i < said.elements.size(); ++i) first.emplace(said.elements[i], i);
  std::vector<std::size_t> least_end;  // of an increasing subsequence of length 1, 2, ...
  for (const auto& element : right.elements) {
    const auto place = first.find(element);
    if (place == first.end()) continue;
    const auto longer = std::lower_bound(least_end.begin(), least_end.end(), place->second);
    if (longer == least_end.end()) least_end.push_back(place->second);
    else *longer = place->second;
  }
  return right.elements.size() - least_end.size();
}

}  // namespace

std::vector<Listed> listed(const Shape& shape, const std::vector<Word>& words) {
  std::vector<Listed> lists;
  const Word* at = words.data();
  collect(shape, "", at, lists);
  return lists;
}

Covering covered(const Shape& shape, const std::vector<Word>& truth, const std::vector<Word>& answer) {
  std::vector<Listed> right = listed(shape, truth), said = listed(shape, answer);
  said.resize(right.size());
  Covering found;
  for (std::size_t i = 0; i < right.size(); ++i) {
    const std::uint64_t misplaced = std::strcmp(right[i].name, "in_order") == 0 ? out_of_order(right[i], said[i]) : 0;
    for (auto* list : {&right[i].elements, &said[i].elements}) {
      for (auto& element : *list) std::sort(element.begin(), element.end());
      std::sort(list->begin(), list->end());
    }
    const auto &all = right[i].elements, &given = said[i].elements;
    std::vector<std::vector<Word>> common;
    std::set_intersection(all.begin(), all.end(), given.begin(), given.end(), std::back_inserter(common));
    found.missing += std::max<std::uint64_t>(all.size() - common.size(), misplaced);
    found.surplus += given.size() - common.size();
  }
  return found;
}

bool same_as_truth(const Shape& shape, const EncodedTruth& truth, const EncodedValue<Exact>& answer, Reading reading) {
  bool numbers = true;
  SideBySide<Exact> both(truth, answer, reading);
  const bool words = both.walk(shape, [&](const TrueNumber& right, const Exact& answered, Meaning) {
    numbers =
        numbers && answered.defined() && (answered.value() == right || nearest(answered.value()) == nearest(right));
  });
  return words && numbers;
}

bool promise_holds(const EncodedValue<double>& plain, const EncodedValue<Tracked>& tracked,
                   const EncodedValue<Exact>& exact) {
  if (plain.words != tracked.words || plain.words != exact.words) return false;
  for (std::size_t i = 0; i < plain.numbers.size(); ++i) {
    const double number = plain.numbers[i];
    const Tracked& bounded = tracked.numbers[i];
    const bool same_bits = number == bounded.value() || (number != number && bounded.value() != bounded.value());
    if (!same_bits) return false;
    if (!std::isfinite(number) || std::isinf(bounded.error()) || !exact.numbers[i].defined())
      continue;  // nothing was promised
    if (abs(exact_value(number) - exact.numbers[i].value()) > exact_value(bounded.error())) return false;
  }
  return true;
}

std::string outcome_of(const Shape& shape, const std::vector<Word>& words, bool partial) {
  std::string outcome;
  WordCursor at{{}, words.data()};
  for_each_word(shape, at, partial, [&](const Shape& word, Word which) {
    outcome += (outcome.empty() ? "" : "/") + std::string(word.words[which]);
  });
  return outcome.empty() ? "value" : outcome;
}

std::size_t outcome_number(const Shape& shape, const std::vector<Word>& words) {
  std::size_t outcome = 0;
  WordCursor at{{}, words.data()};
  for_each_word(shape, at, false,
                [&](const Shape& word, Word which) { outcome = outcome * word.words.size() + which; });
  return outcome;
}

std::vector<std::string> words_of(const Shape& shape) {
  std::vector<std::string> all;
  for_each_word_shape(shape, [&](const Shape& part) {
    for (const char* word : part.words) {
      if (std::find(all.begin(), all.end(), word) == all.end()) all.emplace_back(word);
    }
  });
  return all;
}

std::optional<Word> word_in(const Shape& shape, const std::vector<Word>& words, const Shape& type) {
  std::optional<Word> found;
  WordCursor at{{}, words.data()};
  for_each_word(shape, at, false, [&](const Shape& word, Word which) {
    if (!found && &word == &type) found = which;
  });
  return found;
}

std::optional<bool> yes_or_no(const Shape& shape, const std::vector<Word>& words) {
  WordCursor at{{}, words.data()};
  // A shape without enumerators may have no words at all: none is read before the shape is known to have one.
  const auto reading = [&at](const Shape& word) -> std::optional<bool> {
    if (word.kind != Shape::Kind::word || word.no < 0) return std::nullopt;
    return *at.word != static_cast<Word>(word.no);
  };
  if (shape.kind != Shape::Kind::record) return reading(shape);
  for (const Shape::Part& part : shape.parts) {
    if (const auto found = reading(*part.shape)) return found;
    skip(*part.shape, at);
  }
  return std::nullopt;
}

bool has_plain_reading(const Shape& shape) {
  const auto reads = [](const Shape& word) { return word.kind == Shape::Kind::word && word.no >= 0; };
  return reads(shape) || (shape.kind == Shape::Kind::record &&
                          std::any_of(shape.parts.begin(), shape.parts.end(),
                                      [&](const Shape::Part& part) { return reads(*part.shape); }));
}

}  // namespace touchstone::catalogue
