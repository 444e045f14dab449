// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "catalogue/shape/encoded_value.h"

namespace touchstone::catalogue {

/// A type of questions or answers, described at run time: what the numbers and words of an encoded value mean, in
/// order.
struct Shape {
  enum class Kind {
    number,
    word,      ///< an enumerator
    flag,      ///< true or false
    index,     ///< a place in a list
    optional,  ///< a word that says whether it is there, then perhaps a value of the one part
    list,      ///< its length, then values of the one part
    record,    ///< values of all parts
    choice,    ///< which of the parts, then a value of that one
  };
  struct Part {
    const char* name;  ///< in JSON; "" where there is none
    const Shape* shape;
    bool drawn = true;  ///< whether families of the types alone draw it; else it is an empty list
  };

  Kind kind = Kind::number;
  std::string name;                   ///< of an enumeration or a struct: "Segment2<double>"
  Form form = Form::record;           ///< of a record: how JSON writes it
  Meaning meaning = Meaning::number;  ///< of a record's own numbers, else of the number
  std::vector<const char*> words;     ///< of a word: its enumerators
  int no = -1;  ///< of a word: the enumerator that means "no common point", -1 where there is none
  std::vector<Part> parts;
  /// The count of numbers and words of a value; only if it is the same for all values (nothing optional, no list, no
  /// choice).
  bool fixed = true;
  std::size_t numbers = 0, word_count = 0;
};

/// A number of that meaning.
const Shape& number_shape(Meaning meaning);

/// Fills in `fixed`, `numbers` and `word_count` from the parts.
Shape measured(Shape shape);

template <class T>
const Shape& shape_of(Meaning meaning = Meaning::number);

/// As the compiler writes it, with more around it.
template <class T>
constexpr std::string_view written_by_compiler() {
  return __PRETTY_FUNCTION__;
}
/// The name of a type alone, from its qualified name, as users write it with `using namespace touchstone`.
std::string name_of_type(std::string_view written);

/// A type over doubles as users write it: "double", "std::vector<Point3<double>>".
std::string type_text(const Shape& shape);

template <class T>
Shape made_shape() {
  Shape shape;
  if constexpr (is_tuple<T>) {
    shape.kind = Shape::Kind::record;
    [&]<class... Ts>(const std::tuple<Ts...>*) {
      (shape.parts.push_back({"", &shape_of<Ts>()}), ...);
    }(static_cast<const T*>(nullptr));
  } else if constexpr (Enumeration<T>) {
    shape.kind = Shape::Kind::word;
    shape.name = name_of_type(written_by_compiler<T>());
    shape.words.assign(Words<T>::words.begin(), Words<T>::words.end());
    if constexpr (requires { Words<T>::no; }) shape.no = static_cast<int>(Words<T>::no);
  } else if constexpr (Plain<T>) {
    shape.kind = std::is_same_v<T, bool> ? Shape::Kind::flag : Shape::Kind::index;
  } else if constexpr (is_optional<T>) {
    shape.kind = Shape::Kind::optional;
    shape.parts.push_back({"", &shape_of<typename T::value_type>()});
  } else if constexpr (is_vector<T>) {
    shape.kind = Shape::Kind::list;
    shape.parts.push_back({"", &shape_of<typename T::value_type>()});
  } else if constexpr (is_variant<T>) {
    shape.kind = Shape::Kind::choice;
    [&]<class... Ts>(const std::variant<Ts...>*) {
      (shape.parts.push_back({"", &shape_of<Ts>()}), ...);
    }(static_cast<const T*>(nullptr));
  } else {
    static_assert(Composite<T>);
    shape.kind = Shape::Kind::record;
    shape.name = name_of_type(written_by_compiler<T>());
    shape.form = T::members.form;
    shape.meaning = T::members.meaning;
    [&]<class... Part>(Types<Part...>) {
      (shape.parts.push_back({T::members.names[shape.parts.size()], &shape_of<Part>(shape.meaning)}), ...);
    }(member_types<T>());
    if (shape.form == Form::mesh) shape.parts.back().drawn = false;
  }
  return measured(std::move(shape));
}

/// The shape of a type over doubles, made once; the meaning is for numbers alone.
template <class T>
const Shape& shape_of(Meaning meaning) {
  if constexpr (std::is_floating_point_v<T>) {
    return number_shape(meaning);
  } else {
    static const Shape made = made_shape<T>();
    return made;
  }
}

/// Calls what there is for every leaf of a value in canonical order, moving the cursor past it:
///   visit.number(shape, cursor), visit.word(shape, cursor); the length of a list is a word too.
template <class Real, class Visit>
void walk_encoded(const Shape& shape, Cursor<Real>& at, Visit& visit) {
  switch (shape.kind) {
    case Shape::Kind::number:
      visit.number(shape, at);
      ++at.number;
      return;
    case Shape::Kind::word:
    case Shape::Kind::flag:
    case Shape::Kind::index:
      visit.word(shape, at);
      ++at.word;
      return;
    case Shape::Kind::optional:
      visit.word(shape, at);
      if (*at.word++ != 0) walk_encoded(*shape.parts[0].shape, at, visit);
      return;
    case Shape::Kind::list: {
      visit.word(shape, at);
      const Word length = *at.word++;
      for (Word i = 0; i < length; ++i) walk_encoded(*shape.parts[0].shape, at, visit);
      return;
    }
    case Shape::Kind::choice: {
      visit.word(shape, at);
      const Word which = *at.word++;
      walk_encoded(*shape.parts[which].shape, at, visit);
      return;
    }
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) walk_encoded(*part.shape, at, visit);
  }
}

/// The place of each number of a question among all its numbers and words in canonical order.
std::vector<std::size_t> places_of_numbers(const Shape& shape, const Question& question);

/// The count of elements of all lists of a question.
Word elements_of_lists(const Shape& shape, const Question& question);

/// Every number 0, every word 0 (the first alternative), lists of that length.
void append_zeros(const Shape& shape, std::size_t list_length, Question& question);

/// The same encoded value over another number type.
template <class To, class From, class Change>
EncodedValue<To> encoded_with(const EncodedValue<From>& encoded, const Change& change) {
  EncodedValue<To> result;
  result.words = encoded.words;
  result.numbers.reserve(encoded.numbers.size());
  for (const From& number : encoded.numbers) result.numbers.push_back(change(number));
  return result;
}

}  // namespace touchstone::catalogue
