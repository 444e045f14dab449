// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/shape/shape.h"

namespace touchstone::fuzz {

/// Tells what each number and enumerator of a question is.
struct Layout {
  struct Place {
    std::size_t number, word;  ///< in the encoded value
  };
  struct Point {
    std::size_t first, dimension;  ///< its coordinates are the numbers first .. first + dimension - 1
  };
  struct List {
    std::size_t length;  ///< index of the enumerator that holds it
    const catalogue::Shape* element;
    std::vector<Place> elements;  ///< where each begins, and where the last one ends
  };
  struct Choosable {
    std::size_t place;  ///< index of the enumerator: an enumerator, a flag or an index
    std::uint64_t values;
  };
  std::vector<Point> points;
  std::vector<List> lists;
  std::vector<Choosable> words;
};

Layout layout_of(const catalogue::Shape& shape, const catalogue::Question& question);

/// Inserts a value of the shape, with every number and enumerator 0, at a place of a question.
void insert_zeros(const catalogue::Shape& shape, catalogue::Question& question, const Layout::Place& at);

}  // namespace touchstone::fuzz
