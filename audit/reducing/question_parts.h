// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "audit/uses.h"
#include "catalogue/shape/shape.h"
#include "geometry/polyhedra.h"

/// The positions of the parts of a question, and the question with a part changed.
namespace touchstone::audit::reducing {

/// An index among the numbers and one among the words of a question.
struct Position {
  std::size_t number = 0, word = 0;
};
struct Extent {
  Position begin, end;
};

/// A list that is not part of a mesh.
struct ListPlace {
  const Shape* element;
  std::size_t length_word;      ///< index of its length
  std::vector<Position> begin;  ///< of each element, and the end of the last
  std::size_t size() const { return begin.size() - 1; }
};

/// A number, and how translation and scaling change it.
struct NumberPlace {
  Meaning meaning;
  std::size_t axis = 0;  ///< of a coordinate
};

/// A word that is neither the length of a list nor part of a mesh.
struct WordPlace {
  const Shape* shape;  ///< of an enumerator, a flag, an index, an optional value or a choice
  std::size_t word;
  Extent value{};  ///< of an optional value that is present
};

struct QuestionParts {
  std::vector<ListPlace> lists;  ///< outer ones before those in their elements
  std::vector<Extent> meshes;
  std::vector<NumberPlace> numbers;  ///< one for each number, those of meshes too
  std::vector<WordPlace> words;
};
QuestionParts parts_of(const Shape& shape, const Question& question);

/// Removes the elements first <= i < last of a list.
Question without(const Question& question, const ListPlace& list, std::size_t first, std::size_t last);

/// The same; also removes the elements of other lists that refer to one of these by index (outside of meshes), and
/// renumbers the other indices.
Question without_and_referring(const Shape& shape, const Question& question, const ListPlace& list, std::size_t first,
                               std::size_t last);

/// Replaces the part by another.
Question with_part(const Question& question, const Extent& part, const Question& other);

}  // namespace touchstone::audit::reducing
