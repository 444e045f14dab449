// SPDX-License-Identifier: Apache-2.0
#include "audit/generic.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robust/lines/orientation.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t most_points = 8;

struct Points {
  std::array<std::array<double, 3>, most_points> at{};
  std::size_t count = 0;
};

bool is_point(const Shape& shape) {
  return shape.kind == Shape::Kind::record && shape.meaning == Meaning::place && shape.fixed && shape.word_count == 0 &&
         shape.numbers == shape.parts.size() && (shape.numbers == 2 || shape.numbers == 3);
}

void collect(const Shape& shape, Cursor<double>& from, Points& points) {
  if (is_point(shape)) {
    if (points.count < most_points) {
      std::array<double, 3>& point = points.at[points.count++];
      for (std::size_t i = 0; i < shape.numbers; ++i) point[i] = from.number[i];
    }
    from.number += shape.numbers;
    return;
  }
  switch (shape.kind) {
    case Shape::Kind::number: ++from.number; return;
    case Shape::Kind::word:
    case Shape::Kind::flag:
    case Shape::Kind::index: ++from.word; return;
    case Shape::Kind::optional:
      if (*from.word++ != 0) collect(*shape.parts[0].shape, from, points);
      return;
    case Shape::Kind::list:
      for (Word left = *from.word++; left > 0; --left) collect(*shape.parts[0].shape, from, points);
      return;
    case Shape::Kind::choice: {
      const Word which = *from.word++;
      collect(*shape.parts[which].shape, from, points);
      return;
    }
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) collect(*part.shape, from, points);
  }
}

/// On one line in space if their shadows are on each of two planes of coordinates, and on the third.
bool on_one_line(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c) {
  const auto in_shadow = [&](std::size_t u, std::size_t v) {
    return robust::orientation({a[u], a[v]}, {b[u], b[v]}, {c[u], c[v]}) == Side::on;
  };
  return in_shadow(0, 1) && in_shadow(1, 2) && in_shadow(2, 0);
}

}  // namespace

bool in_general_position(const Operation& operation, const Question& question) {
  const auto finite = [](double number) { return std::isfinite(number); };
  if (!std::all_of(question.numbers.begin(), question.numbers.end(), finite)) return false;
  Points points;
  Cursor<double> from(question);
  collect(operation.question_shape(), from, points);
  for (std::size_t i = 0; i < points.count; ++i) {
    for (std::size_t j = i + 1; j < points.count; ++j) {
      if (points.count == 2 && points.at[i] == points.at[j]) return false;
      for (std::size_t k = j + 1; k < points.count; ++k) {
        if (on_one_line(points.at[i], points.at[j], points.at[k])) return false;
      }
    }
  }
  return true;
}

}  // namespace touchstone::audit
