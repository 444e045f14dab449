// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "catalogue/codec/walk.h"
#include "catalogue/judge/exact.h"
#include "catalogue/judge/tracked.h"
#include "catalogue/judge/ulps.h"

/// Compares described answers, member by member.
namespace touchstone::audit {

struct Comparison {
  bool decision = true;  ///< every word equal, every number that should be there is there
  bool finite = true;    ///< no NaN, no infinity where the truth rounds to a finite number
  double ulps = 0;       ///< the greatest distance of a number
};

/// `complete`: a number that the truth has must be there (ours); an engine may answer less than we do, and then `Answer` is over
/// std::optional<double>.
template <class Exactly, class Answer>
void compare(const Exactly& truth, const Answer& answer, bool complete, bool binary32, Comparison& result) {
  if constexpr (Enumeration<Answer> || Plain<Answer>) {
    result.decision = result.decision && truth == answer;
  } else if constexpr (is_vector<Answer>) {
    result.decision = result.decision && truth.size() == answer.size();
    for (std::size_t i = 0; i < std::min(truth.size(), answer.size()); ++i)
      compare(truth[i], answer[i], complete, binary32, result);
  } else if constexpr (Composite<Answer>) {
    std::apply(
        [&](const auto&... t) {
          std::apply(
              [&](const auto&... a) {
                (compare(truth.*t.pointer, answer.*a.pointer, complete, binary32, result), ...);
              },
              Described<Answer>::members);
        },
        Described<Exactly>::members);
  } else if constexpr (is_optional<Answer> && !is_optional<Exactly>) {
    if (answer) compare(truth, *answer, complete, binary32, result);
  } else if constexpr (is_optional<Answer>) {
    if (truth && answer) {
      compare(*truth, *answer, complete, binary32, result);
    } else if (complete && truth.has_value() != answer.has_value()) {
      result.decision = false;
    }
  } else {
    const double ulps = distance_in_ulps(static_cast<double>(answer), truth, binary32);
    if (std::isinf(ulps)) result.finite = false;
    result.ulps = std::max(result.ulps, ulps);
  }
}

/// Whether a formula run in exact arithmetic gave the truth: words equal, numbers defined and the same. `complete` as above.
template <class Exactly, class Answer>
bool same_as_truth(const Exactly& truth, const Answer& answer, bool complete = true) {
  if constexpr (Enumeration<Answer> || Plain<Answer>) {
    return truth == answer;
  } else if constexpr (is_vector<Answer>) {
    bool same = truth.size() == answer.size();
    for (std::size_t i = 0; same && i < truth.size(); ++i) same = same_as_truth(truth[i], answer[i], complete);
    return same;
  } else if constexpr (Composite<Answer>) {
    bool same = true;
    std::apply(
        [&](const auto&... t) {
          std::apply(
              [&](const auto&... a) {
                ((same = same && same_as_truth(truth.*t.pointer, answer.*a.pointer, complete)), ...);
              },
              Described<Answer>::members);
        },
        Described<Exactly>::members);
    return same;
  } else if constexpr (is_optional<Answer>) {
    if (!answer) return !truth || !complete;
    return truth.has_value() && same_as_truth(*truth, *answer, complete);
  } else {
    return answer.defined() && (answer.value() == truth || nearest(answer.value()) == nearest(truth));
  }
}

/// What running error analysis promises: `plain` (run in double) is bit for bit what `tracked` computed, and within its
/// bound of `exact`. Both words and numbers; call only where no comparison was in doubt.
template <class InFloat, class Bounded, class Exactly>
bool promise_holds(const InFloat& plain, const Bounded& tracked, const Exactly& exact) {
  if constexpr (Enumeration<InFloat> || Plain<InFloat>) {
    return plain == tracked && plain == exact;
  } else if constexpr (is_vector<InFloat>) {
    bool holds = plain.size() == tracked.size() && plain.size() == exact.size();
    for (std::size_t i = 0; holds && i < plain.size(); ++i) holds = promise_holds(plain[i], tracked[i], exact[i]);
    return holds;
  } else if constexpr (Composite<InFloat>) {
    bool holds = true;
    std::apply(
        [&](const auto&... p) {
          std::apply(
              [&](const auto&... t) {
                std::apply(
                    [&](const auto&... e) {
                      ((holds = holds && promise_holds(plain.*p.pointer, tracked.*t.pointer, exact.*e.pointer)), ...);
                    },
                    Described<Exactly>::members);
              },
              Described<Bounded>::members);
        },
        Described<InFloat>::members);
    return holds;
  } else if constexpr (is_optional<InFloat>) {
    if (!plain || !tracked || !exact)
      return plain.has_value() == tracked.has_value() && plain.has_value() == exact.has_value();
    return promise_holds(*plain, *tracked, *exact);
  } else {
    const bool same_bits = plain == tracked.value() || (plain != plain && tracked.value() != tracked.value());
    if (!same_bits) return false;
    if (!std::isfinite(plain) || std::isinf(tracked.error()) || !exact.defined()) return true;  // nothing was promised
    return abs(exact_value(plain) - exact.value()) <= exact_value(tracked.error());
  }
}

/// The words of a described value, in order ("hit", "convex/ccw"); "value" where there is none.
template <class T>
std::string word_of(const T& value) {
  if constexpr (Enumeration<T>) {
    return Words<T>::words[static_cast<std::size_t>(value)];
  } else if constexpr (Composite<T>) {
    std::string words;
    for_each_member<T>([&](const auto& member) {
      const std::string word = word_of(value.*member.pointer);
      if (word != "value") words += (words.empty() ? "" : "/") + word;
    });
    return words.empty() ? "value" : words;
  } else {
    return "value";
  }
}

/// Every word that an answer of this type can hold, each once.
template <class T>
void append_words(std::vector<std::string>& words) {
  if constexpr (Enumeration<T>) {
    for (const char* word : Words<T>::words) {
      if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
    }
  } else if constexpr (Composite<T>) {
    for_each_member<T>([&](const auto& member) {
      append_words<std::remove_cvref_t<decltype(std::declval<T>().*member.pointer)>>(words);
    });
  }
}

/// The first word of that type in an answer; empty if it holds none.
template <Enumeration Word, class T>
std::optional<Word> word_in(const T& value) {
  std::optional<Word> found;
  if constexpr (std::is_same_v<T, Word>) {
    found = value;
  } else if constexpr (Composite<T>) {
    for_each_member<T>([&](const auto& member) {
      if (!found) found = word_in<Word>(value.*member.pointer);
    });
  }
  return found;
}

/// The plain answer to "do they meet?" / "is it in the closed shape?"; empty where the operation has no such reading.
template <class T>
std::optional<bool> yes_or_no(const T& value) {
  if constexpr (Enumeration<T>) {
    if constexpr (requires { Words<T>::no; }) return value != Words<T>::no;
    return std::nullopt;
  } else if constexpr (Composite<T>) {
    std::optional<bool> reading;
    for_each_member<T>([&](const auto& member) {
      if constexpr (Enumeration<std::remove_cvref_t<decltype(value.*member.pointer)>>) {
        if (!reading) reading = yes_or_no(value.*member.pointer);
      }
    });
    return reading;
  } else {
    return std::nullopt;
  }
}

}  // namespace touchstone::audit
