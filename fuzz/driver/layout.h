// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/shape/shape.h"

namespace touchstone::fuzz {

/// Which numbers and words of a question are what.
struct Layout {
  struct Place {
    std::size_t number, word;  ///< on the encoded value
  };
  struct Point {
    std::size_t first, dimension;  ///< its coordinates are numbers first .. first + dimension - 1
  };
  struct List {
    std::size_t length;  ///< the word
    const catalogue::Shape* element;
    std::vector<Place> elements;  ///< where each begins, and behind the last where it ends
  };
  struct Choosable {
    std::size_t place;  ///< the word: an enumerator, a flag, an index
    std::uint64_t values;
  };
  std::vector<Point> points;
  std::vector<List> lists;
  std::vector<Choosable> words;
};

Layout layout_of(const catalogue::Shape& shape, const catalogue::Question& question);

/// A value of that shape with every number and word 0, at a place of a question.
void insert_zeros(const catalogue::Shape& shape, catalogue::Question& question, const Layout::Place& at);

}  // namespace touchstone::fuzz
