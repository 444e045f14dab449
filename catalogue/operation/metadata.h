// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>

#include "catalogue/operation/growth.h"

namespace touchstone::catalogue {

/// How the answers of an operation are compared with the truth.
enum class Kind {
  decision,  ///< equal
  measure,   ///< numbers: distance from the exact value in units in the last place
  set,       ///< equal after canonical order
  checked,   ///< a checker accepts
  covering,  ///< nothing missing; what is too much is counted apart
};

/// A list of constants. With it a Metadata is a constant too, which needs no initialization at run time: there g++ and
/// clang disagree on who stores the members that are constants, and a program may have rows of both.
template <class T, std::size_t most>
class ShortList {
 public:
  using value_type = T;
  constexpr ShortList(std::initializer_list<T> values) : size_(values.size()) {
    if (values.size() > most) throw std::length_error("ShortList: too many values");
    std::size_t i = 0;
    for (const T& value : values) values_[i++] = value;
  }
  constexpr ShortList() = default;
  constexpr const T* begin() const { return values_.data(); }
  constexpr const T* end() const { return begin() + size_; }
  constexpr std::size_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr const T& operator[](std::size_t i) const { return values_.at(i); }

 private:
  std::array<T, most> values_{};
  std::size_t size_ = 0;
};
/// Names of the inputs in JSON, in order.
using FieldNames = ShortList<const char*, 6>;

/// What the catalogue says of an operation.
struct Metadata {
  const char* name;
  const char* chapter;
  const char* pages;     ///< of the deck
  const char* question;  ///< one plain sentence: what is asked
  Kind kind = Kind::decision;
  FieldNames fields{};
  /// Where the alternatives of a question have names of their own: those of the second, the third ... alternative.
  ShortList<FieldNames, 3> other_fields{};
  const char* answer = "";  ///< the answer's field name where the answer is one bare value
  double ulps = 0;          ///< stated bound of the reference's numbers: roundings in the textbook formula
  /// The oracle's margin is a length to this power; 0 where nothing is decided, so that there is no margin.
  int margin_degree = 1;
  /// What examining one question costs, measured (proptests/costs.py): 1 is 45 microseconds or less. Tests ask so
  /// many times fewer cases.
  int cost = 1;
  Time time{};                  ///< as it grows with the lists
  std::size_t list_length = 0;  ///< exhaustive runs: how many elements each list has, where there are lists
  /// The operation whose question this is, answered in another way: its row derives from that operation's, and has a
  /// reference, a robust or both of its own. Families, truth and vectors are the operation's; no engine is asked it.
  const char* implementation_of = "";
  bool is_implementation() const { return implementation_of[0] != 0; }
  /// The textbook formula leaves out numbers that the operation answers, and is judged on the others.
  bool formula_answers_less = false;
  /// Test vectors of more characters are left out: three coordinates of hundreds of digits each (0: none).
  std::size_t longest_vector = 0;
};

}  // namespace touchstone::catalogue
