// SPDX-License-Identifier: Apache-2.0
#include "report/words/answered.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "catalogue/draw/by_shape.h"
#include "geometry/invalid_input.h"

namespace touchstone::report {
namespace {

double finite_number(const Json& json, const std::string& field) {
  if (!json.is_number()) throw InvalidInput(field, "expected a number");
  return json.get<double>();
}

/// The corners that a list of indices names; empty if one is not a point of the plane.
std::vector<double> corners_of(const Json& indices, const Json& points) {
  std::vector<double> numbers;
  for (const Json& index : indices) {
    const double at = index.is_number() ? index.get<double>() : -1;
    if (!(at >= 0 && at < static_cast<double>(points.size()))) return {};
    const Json& point = points[static_cast<std::size_t>(at)];
    if (!point.is_array() || point.size() != 2) return {};
    for (const Json& coordinate : point) {
      if (!coordinate.is_number()) return {};
      numbers.push_back(coordinate.get<double>());
    }
  }
  return numbers;
}

bool all_indices(const Shape& shape) {
  return (shape.kind == Shape::Kind::list || shape.kind == Shape::Kind::record) &&
         std::all_of(shape.parts.begin(), shape.parts.end(),
                     [](const Shape::Part& part) { return part.shape->kind == Shape::Kind::index; });
}

/// Draws the parts that have a figure; indices refer to `points`.
void draw_parts(Drawing& said, const Shape& shape, const Json& json, const std::string& field, const Json& points) {
  if (has_figure(shape)) {
    try {
      EncodedValue<double> encoded;
      read_json<double>(shape, json, field, encoded, finite_number);
      Cursor<double> at(encoded);
      draw_figure(said, shape, field, at, false);
    } catch (const InvalidInput&) {
      // An answer of another alternative, or none at all.
    }
  } else if (shape.kind == Shape::Kind::optional || shape.kind == Shape::Kind::choice) {
    for (const Shape::Part& part : shape.parts) draw_parts(said, *part.shape, json, field, points);
  } else if (all_indices(shape) && json.is_array()) {
    const std::vector<double> ring = corners_of(json, points);
    if (ring.size() >= 4)
      said.figures.push_back({ring.size() > 4 ? Figure::Kind::polygon : Figure::Kind::segment, field, ring});
  } else if (shape.kind == Shape::Kind::list && json.is_array()) {
    for (const Json& element : json) draw_parts(said, *shape.parts[0].shape, element, field, points);
  } else if (shape.kind == Shape::Kind::record && json.is_object()) {
    for (const Shape::Part& part : shape.parts) {
      if (json.contains(part.name)) draw_parts(said, *part.shape, json[part.name], part.name, points);
    }
  }
}

/// The extent of a scene's figures in their coordinates, dimension by dimension.
struct Extents {
  std::size_t dimension;
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void put(const std::vector<double>& numbers, std::size_t count, double room) {
    for (std::size_t i = 0; i < count; ++i) {
      low[i % dimension] = std::min(low[i % dimension], numbers[i] - room);
      high[i % dimension] = std::max(high[i % dimension], numbers[i] + room);
    }
  }
  /// True if the first `count` numbers are within one more size of the figures.
  bool near(const std::vector<double>& numbers, std::size_t count) const {
    double size = 0;
    for (std::size_t i = 0; i < dimension; ++i) size = std::max(size, high[i] - low[i]);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t axis = i % dimension;
      if (!(numbers[i] >= low[axis] - size && numbers[i] <= high[axis] + size)) return false;
    }
    return true;
  }
};

bool is_round(const Figure& figure) { return figure.kind == Figure::Kind::circle; }
bool is_round(const SpaceFigure& figure) { return figure.kind == SpaceFigure::Kind::sphere; }
bool is_endless(const Figure& figure) { return figure.kind == Figure::Kind::line || figure.kind == Figure::Kind::ray; }
bool is_endless(const SpaceFigure& figure) { return figure.kind == SpaceFigure::Kind::plane; }

/// True if an answer may contain an index out of range.
bool has_index(const Shape& shape) {
  return shape.kind == Shape::Kind::index ||
         std::any_of(shape.parts.begin(), shape.parts.end(),
                     [](const Shape::Part& part) { return has_index(*part.shape); });
}

/// The operation's own drawing of the answer; empty if it has none, or if the answer is incomplete.
Drawing as_truth(const Operation& operation, const Json& answer, const Question& question) {
  Drawing drawing;
  if (operation.row().draw == nullptr || has_index(operation.answer_shape())) return drawing;
  try {
    EncodedValue<double> encoded;
    read_json<double>(operation.answer_shape(), answer, "", encoded, finite_number);
    operation.row().draw(drawing, question, encoded);
  } catch (const InvalidInput&) {
    return {};
  }
  return drawing;
}

template <class AnyFigure>
std::vector<AnyFigure> of_answer(const std::vector<AnyFigure>& figures) {
  std::vector<AnyFigure> own;
  std::copy_if(figures.begin(), figures.end(), std::back_inserter(own), [](const auto& f) { return f.answer; });
  return own;
}

/// Bodies move according to the answer; if it is not drawn, they do not move.
void let_move_as_answered(std::vector<SpaceFigure>& bodies, const std::vector<SpaceFigure>& answered) {
  for (SpaceFigure& body : bodies) {
    const auto same = std::find_if(answered.begin(), answered.end(), [&](const SpaceFigure& other) {
      return other.moves && other.kind == body.kind && other.label == body.label;
    });
    if (body.moves) body.moves = same == answered.end() ? std::nullopt : same->moves;
  }
}

/// `placed`: vectors are already at their positions.
template <class AnyFigure>
void take_over(std::vector<AnyFigure>& drawn, std::vector<AnyFigure> said, std::size_t dimension, bool placed) {
  const auto coordinates = [&](const AnyFigure& figure) {
    return is_round(figure) ? dimension : figure.numbers.size();
  };
  Extents extents{dimension};
  for (const AnyFigure& figure : drawn) {
    if constexpr (std::is_same_v<AnyFigure, SpaceFigure>)
      if (is_endless(figure)) continue;
    extents.put(figure.numbers, coordinates(figure), is_round(figure) ? figure.numbers[dimension] : 0);
  }
  for (AnyFigure& figure : said) {
    const auto truth = std::find_if(drawn.begin(), drawn.end(), [&](const AnyFigure& other) {
      return other.answer && other.kind == figure.kind && other.label == figure.label;
    });
    if (figure.kind == AnyFigure::Kind::arrow && !placed) {
      // A vector is drawn where the truth's is.
      if (truth == drawn.end()) continue;
      for (std::size_t i = 0; i < dimension; ++i) {
        figure.numbers[i] = truth->numbers[i];
        figure.numbers[i + dimension] += truth->numbers[i];
      }
    }
    const bool true_one = std::any_of(drawn.begin(), drawn.end(), [&](const AnyFigure& other) {
      return other.answer && other.numbers == figure.numbers;
    });
    if (true_one || is_endless(figure) || !extents.near(figure.numbers, coordinates(figure))) continue;
    figure.label = placed ? "answered: " + figure.label : "answered";
    figure.said = true, figure.answer = false;
    drawn.push_back(std::move(figure));
  }
}

}  // namespace

void draw_answered(Drawing& scene, const Operation& operation, const Json& answer, const Question& question) {
  Json points;
  for (const Json& field : operation.print(question)) {
    if (points.is_null() && field.is_array() && !field.empty() && field[0].is_array()) points = field;
  }
  Drawing said;
  const std::string bare = operation.metadata().answer;
  const bool named = !bare.empty() && answer.is_object() && answer.contains(bare);
  const Json& bare_answer = named ? answer[bare] : answer;
  draw_parts(said, operation.answer_shape(), bare_answer, named ? bare : "", points);
  const bool in_plane = !scene.figures.empty();
  in_plane ? take_over(scene.figures, std::move(said.figures), 2, false)
           : take_over(scene.space, std::move(said.space), 3, false);
  const Drawing own = as_truth(operation, bare_answer, question);
  let_move_as_answered(scene.space, own.space);
  in_plane ? take_over(scene.figures, of_answer(own.figures), 2, true)
           : take_over(scene.space, of_answer(own.space), 3, true);
}

}  // namespace touchstone::report
