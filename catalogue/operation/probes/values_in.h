// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// Calls visit(value, its position) for each value of that type in a question.
template <class T, class Visit>
void for_each_value(const Shape& shape, Cursor<double>& at, const Visit& visit) {
  const Cursor<double> start = at;
  if (&shape == &shape_of<T>()) {
    T value{};
    unpack(value, at, as_it_is);
    return visit(value, start);
  }
  switch (shape.kind) {
    case Shape::Kind::number: ++at.number; return;
    case Shape::Kind::word:
    case Shape::Kind::flag:
    case Shape::Kind::index: ++at.word; return;
    case Shape::Kind::optional:
      if (*at.word++ != 0) for_each_value<T>(*shape.parts[0].shape, at, visit);
      return;
    case Shape::Kind::list:
      for (Word left = *at.word++; left > 0; --left) for_each_value<T>(*shape.parts[0].shape, at, visit);
      return;
    case Shape::Kind::choice: {
      const Word which = *at.word++;
      return for_each_value<T>(*shape.parts[which].shape, at, visit);
    }
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) for_each_value<T>(*part.shape, at, visit);
  }
}
template <class T, class Visit>
void for_each_value(const Operation& operation, const Question& question, const Visit& visit) {
  Cursor<double> at(question);
  for_each_value<T>(*operation.row().question, at, visit);
}

}  // namespace touchstone::catalogue
