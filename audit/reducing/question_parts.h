// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "audit/uses.h"
#include "catalogue/shape/shape.h"
#include "geometry/polyhedra.h"

/// Where the parts of a question stand, and the question with a part changed.
namespace touchstone::audit::reducing {

/// A place among the numbers and one among the words of a question.
struct Position {
  std::size_t number = 0, word = 0;
};
struct Extent {
  Position begin, end;
};

/// A list that is no part of a mesh.
struct ListPlace {
  const Shape* element;
  std::size_t length_word;      ///< where its length stands
  std::vector<Position> begin;  ///< of each element, and where the last one ends
  std::size_t size() const { return begin.size() - 1; }
};

/// A number, and how places and scales change it.
struct NumberPlace {
  Meaning meaning;
  std::size_t axis = 0;  ///< of a coordinate
};

/// A word that is neither the length of a list nor part of a mesh.
struct WordPlace {
  const Shape* shape;  ///< of a word, a flag, an index, an optional value or a choice
  std::size_t word;
  Extent value{};  ///< of an optional value that is there
};

struct QuestionParts {
  std::vector<ListPlace> lists;  ///< outer ones before those in their elements
  std::vector<Extent> meshes;
  std::vector<NumberPlace> numbers;  ///< one for each number, those of meshes too
  std::vector<WordPlace> words;
};
QuestionParts parts_of(const Shape& shape, const Question& question);

/// Without the elements first <= i < last of a list.
Question without(const Question& question, const ListPlace& list, std::size_t first, std::size_t last);

/// The same; in other lists the elements go that refer to one of these by its place (an index outside of meshes), and
/// the other places are counted anew.
Question without_and_referring(const Shape& shape, const Question& question, const ListPlace& list, std::size_t first,
                               std::size_t last);

/// The part replaced by another.
Question with_part(const Question& question, const Extent& part, const Question& other);

}  // namespace touchstone::audit::reducing
