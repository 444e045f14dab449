// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/generic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <vector>

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

bool is_vector(const Shape& shape) {
  return shape.kind == Shape::Kind::record && shape.meaning == Meaning::direction && shape.fixed &&
         shape.numbers == shape.parts.size();
}
/// True for a shape given by two corners.
bool is_box(const Shape& shape) { return shape.parts.size() == 2 && std::strcmp(shape.parts[0].name, "min") == 0; }

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

/// The range of a value.
struct Extent {
  Cursor<double> from, to;
  std::size_t numbers() const { return static_cast<std::size_t>(to.number - from.number); }
};
bool same(const Extent& a, const Extent& b) {
  return std::equal(a.from.number, a.to.number, b.from.number, b.to.number) &&
         std::equal(a.from.word, a.to.word, b.from.word, b.to.word);
}

/// Counts the degenerate features of a value, part by part.
class Features {
 public:
  std::size_t count = 0;

  Extent look(const Shape& shape, Cursor<double>& at) {
    const Cursor<double> from = at;
    switch (shape.kind) {
      case Shape::Kind::number: count += shape.meaning == Meaning::length && *at.number == 0, ++at.number; break;
      case Shape::Kind::word:
      case Shape::Kind::flag:
      case Shape::Kind::index: ++at.word; break;
      case Shape::Kind::optional:
        if (*at.word++ != 0) look(*shape.parts[0].shape, at);
        break;
      case Shape::Kind::list: look_at_list(*shape.parts[0].shape, at); break;
      case Shape::Kind::choice: {
        const Word which = *at.word++;
        look(*shape.parts[which].shape, at);
        break;
      }
      case Shape::Kind::record: look_at_parts(shape, at); break;
    }
    return {from, at};
  }

 private:
  void look_at_list(const Shape& element, Cursor<double>& at) {
    const Word length = *at.word++;
    count += length == 0;
    std::vector<Extent> first;
    for (Word i = 0; i < length; ++i) {
      const Extent extent = look(element, at);
      if (first.size() < most_points && extent.numbers() > 1) first.push_back(extent);
    }
    for (std::size_t i = 0; i < first.size(); ++i)
      for (std::size_t k = i + 1; k < first.size(); ++k) count += same(first[i], first[k]);
  }

  void look_at_parts(const Shape& shape, Cursor<double>& at) {
    const double* const numbers = at.number;
    std::vector<Extent> parts;
    for (const Shape::Part& part : shape.parts) parts.push_back(look(*part.shape, at));
    if (is_vector(shape)) count += std::all_of(numbers, at.number, [](double number) { return number == 0; });
    if (shape.form == Form::record && is_box(shape)) {
      for (std::size_t axis = 0; axis < parts[0].numbers(); ++axis)
        count += parts[0].from.number[axis] == parts[1].from.number[axis];
      return;
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t k = i + 1; k < parts.size(); ++k)
        count += shape.parts[i].shape == shape.parts[k].shape && parts[i].numbers() > 1 && same(parts[i], parts[k]);
  }
};

/// Looks for a direction with a component of 0.
struct OnAxis {
  bool found = false;

  void look(const Shape& shape, Cursor<double>& at) {
    switch (shape.kind) {
      case Shape::Kind::number: ++at.number; return;
      case Shape::Kind::word:
      case Shape::Kind::flag:
      case Shape::Kind::index: ++at.word; return;
      case Shape::Kind::optional:
        if (*at.word++ != 0) look(*shape.parts[0].shape, at);
        return;
      case Shape::Kind::list:
        for (Word left = *at.word++; left > 0; --left) look(*shape.parts[0].shape, at);
        return;
      case Shape::Kind::choice: {
        const Word which = *at.word++;
        look(*shape.parts[which].shape, at);
        return;
      }
      case Shape::Kind::record: break;
    }
    const double* const numbers = at.number;
    for (const Shape::Part& part : shape.parts) look(*part.shape, at);
    const std::size_t count = shape.parts.size();
    if (is_vector(shape)) found = found || std::find(numbers, at.number, 0.0) != at.number;
    if (count != 2 || is_box(shape) || !is_point(*shape.parts[0].shape) || !is_point(*shape.parts[1].shape)) return;
    const double* const second = numbers + shape.parts[0].shape->numbers;
    found = found || !std::equal(numbers, second, second, std::not_equal_to<>());
  }
};

/// Points are collinear in space if their projections on two coordinate planes are, and on the third.
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

bool has_direction_on_axis(const Operation& operation, const Question& question) {
  OnAxis looking;
  Cursor<double> at(question);
  looking.look(operation.question_shape(), at);
  return looking.found;
}

std::size_t degenerate_features(const Operation& operation, const Question& question, bool margin_is_0) {
  Features features;
  Cursor<double> at(question);
  features.look(operation.question_shape(), at);
  return features.count + margin_is_0 + !in_general_position(operation, question);
}

}  // namespace touchstone::audit
