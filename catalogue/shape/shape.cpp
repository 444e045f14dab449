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

std::string name_of_type(std::string_view written) {
  std::string text(written.substr(written.find("T = ") + 4));
  text.erase(text.find_first_of(";]"));
  const std::string space = "touchstone::";
  for (std::size_t at; (at = text.find(space)) != std::string::npos;) text.erase(at, space.size());
  for (std::size_t at; (at = text.find("> >")) != std::string::npos;) text.erase(at + 1, 1);  // as g++ writes it
  return text;
}

std::string type_text(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::number: return "double";
    case Shape::Kind::flag: return "bool";
    case Shape::Kind::index: return "Index";
    case Shape::Kind::optional: return "std::optional<" + type_text(*shape.parts[0].shape) + ">";
    case Shape::Kind::list: return "std::vector<" + type_text(*shape.parts[0].shape) + ">";
    case Shape::Kind::choice: {
      std::string types;
      for (const Shape::Part& part : shape.parts) types += (types.empty() ? "" : ", ") + type_text(*part.shape);
      return "std::variant<" + types + ">";
    }
    default: return shape.name;
  }
}

std::vector<std::size_t> places_of_numbers(const Shape& shape, const Question& question) {
  struct Places {
    std::size_t slots = 0;
    std::vector<std::size_t> found{};
    void number(const Shape&, const Cursor<double>&) { found.push_back(slots++); }
    void word(const Shape&, const Cursor<double>&) { ++slots; }
  } places;
  Cursor<double> at(question);
  walk_encoded(shape, at, places);
  return places.found;
}

Word elements_of_lists(const Shape& shape, const Question& question) {
  struct Counted {
    Word elements = 0;
    void number(const Shape&, const Cursor<double>&) {}
    void word(const Shape& part, const Cursor<double>& at) {
      if (part.kind == Shape::Kind::list) elements += *at.word;
    }
  } counted;
  Cursor<double> at(question);
  walk_encoded(shape, at, counted);
  return counted.elements;
}

void append_zeros(const Shape& shape, std::size_t list_length, Question& question) {
  switch (shape.kind) {
    case Shape::Kind::number: question.numbers.push_back(0); return;
    case Shape::Kind::list:
      question.words.push_back(static_cast<Word>(list_length));
      for (std::size_t i = 0; i < list_length; ++i) append_zeros(*shape.parts[0].shape, list_length, question);
      return;
    case Shape::Kind::choice:
      question.words.push_back(0);
      return append_zeros(*shape.parts[0].shape, list_length, question);
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) append_zeros(*part.shape, part.drawn ? list_length : 0, question);
      return;
    default: question.words.push_back(0);
  }
}

}  // namespace touchstone::catalogue
