// SPDX-License-Identifier: Apache-2.0
#include "catalogue/shape/shape.h"

#include <algorithm>
#include <array>

namespace touchstone::catalogue {

const Shape& number_shape(Meaning meaning) {
  static const std::array<Shape, 4> shapes = [] {
    std::array<Shape, 4> made;
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i].meaning = static_cast<Meaning>(i);
      made[i].numbers = 1;
    }
    return made;
  }();
  return shapes[static_cast<std::size_t>(meaning)];
}

Shape measured(Shape shape) {
  switch (shape.kind) {
    case Shape::Kind::number: shape.numbers = 1; break;
    case Shape::Kind::word:
    case Shape::Kind::flag:
    case Shape::Kind::index: shape.word_count = 1; break;
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) {
        shape.fixed = shape.fixed && part.shape->fixed;
        shape.numbers += part.shape->numbers;
        shape.word_count += part.shape->word_count;
      }
      break;
    default: shape.fixed = false;
  }
  return shape;
}

std::vector<std::size_t> places_of_numbers(const Shape& shape, const Question& question) {
  struct Places {
    std::size_t slots = 0;
    std::vector<std::size_t> found{};
    void number(const Shape&, const Cursor<double>&) { found.push_back(slots++); }
    void word(const Shape&, const Cursor<double>&) { ++slots; }
  } places;
  Cursor<double> at(question);
  walk_tape(shape, at, places);
  return places.found;
}

Word longest_list(const Shape& shape, const Question& question) {
  struct Longest {
    Word length = 0;
    void number(const Shape&, const Cursor<double>&) {}
    void word(const Shape& part, const Cursor<double>& at) {
      if (part.kind == Shape::Kind::list) length = std::max(length, *at.word);
    }
  } longest;
  Cursor<double> at(question);
  walk_tape(shape, at, longest);
  return longest.length;
}

}  // namespace touchstone::catalogue
