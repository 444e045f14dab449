// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>

#include "catalogue/operation/growth.h"

namespace touchstone::catalogue {

/// The comparison of an operation's answers with the truth.
enum class Kind {
  decision,  ///< equal
  measure,   ///< numbers: distance from the exact value in units in the last place
  set,       ///< equal after canonical order
  checked,   ///< a checker accepts
  covering,  ///< nothing is missing; surplus is counted separately
};

/// A list of constants. It makes a Metadata constant too, which needs no initialization at run time: there g++ and
/// clang disagree on which of them stores constant members, and a program may have rows of both.
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

struct Implementation;

/// The catalogue's data about an operation.
struct Metadata {
  const char* name;
  const char* chapter;
  const char* pages;     ///< of the deck
  const char* question;  ///< the question in one plain sentence
  Kind kind = Kind::decision;
  FieldNames fields{};
  /// If the alternatives of a question have names of their own: those of the second, the third ... alternative.
  ShortList<FieldNames, 3> other_fields{};
  const char* answer = "";  ///< the answer's field name if the answer is one bare value
  double ulps = 0;          ///< stated bound of the reference's numbers: roundings in the textbook formula
  /// The oracle's margin is a length to this power; 0 if nothing is decided, so that there is no margin.
  int margin_degree = 1;
  /// The cost of examining one question, measured (proptests/costs.py): 1 is 45 microseconds or less. Tests ask fewer
  /// cases by this factor.
  int cost = 1;
  Time time{};                  ///< its growth with the lists
  std::size_t list_length = 0;  ///< exhaustive runs: the number of elements of each list, if there are lists
  /// The operation that asks the same question, if this one answers it differently: this row derives from that
  /// operation's, and has a reference, a robust or both of its own. Families, truth and vectors are the operation's;
  /// engines are not asked this one.
  const char* implementation_of = "";
  /// The metadata of a row that answers this operation.
  constexpr Metadata implementation(const Implementation& own) const;
  bool is_implementation() const { return implementation_of[0] != 0; }
  /// The textbook formula omits numbers that the operation answers, and is judged on the others.
  bool formula_answers_less = false;
  /// Test vectors with more characters are left out: three coordinates of hundreds of digits each (0: no limit).
  std::size_t longest_vector = 0;
};

/// The data of an implementation that are its own.
struct Implementation {
  const char *name, *pages, *question;
  int cost;
  Time time;
};
constexpr Metadata Metadata::implementation(const Implementation& own) const {
  Metadata other = *this;
  other.name = own.name, other.pages = own.pages, other.question = own.question;
  other.implementation_of = name, other.cost = own.cost, other.time = own.time;
  return other;
}

}  // namespace touchstone::catalogue
