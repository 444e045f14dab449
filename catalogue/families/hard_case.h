// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "catalogue/families/draw_stream.h"

namespace touchstone::catalogue {

/// A family of questions that are hard on purpose.
template <class Question>
struct HardCase {
  std::string name;               ///< the family: "collinear", "shared_end" ...
  Question (*draw)(DrawStream&);  ///< integers and other exact parameters, so that a shrunk case stays degenerate
  /// Neither scaled nor, as a family of its own, moved by an ulp: its mesh has to stay one that test vectors can name,
  /// or its lists are so long that once is dear enough.
  bool unscaled = false;
};

/// The hard cases of an operation, to which its row adds one after another.
template <class Question>
class HardCases {
 public:
  void operator()(const char* name, Question (*draw)(DrawStream&)) { all_.push_back({name, draw}); }
  void unscaled(const char* name, Question (*draw)(DrawStream&)) { all_.push_back({name, draw, true}); }
  std::vector<HardCase<Question>> all() && { return std::move(all_); }

 private:
  std::vector<HardCase<Question>> all_;
};

/// The two parts of a question, whichever first.
template <class T>
std::tuple<T, T> in_either_order(DrawStream& draws, const T& a, const T& b) {
  return draws.coin() ? std::tuple(b, a) : std::tuple(a, b);
}

template <class Row>
std::vector<HardCase<typename Row::Question>> hard_cases_of() {
  HardCases<typename Row::Question> add;
  Row::hard_cases(add);
  return std::move(add).all();
}

}  // namespace touchstone::catalogue
