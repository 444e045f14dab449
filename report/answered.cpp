// SPDX-License-Identifier: Apache-2.0
#include "report/answered.h"

#include <algorithm>
#include <cmath>

namespace touchstone::audit {
namespace {

/// All numbers in a field of an answer; empty where one is not finite.
std::vector<double> numbers_in(const Json& field) {
  std::vector<double> numbers;
  const Json flat = field.flatten();
  for (const auto& number : flat) {
    if (!number.is_number()) return {};
    numbers.push_back(number.get<double>());
  }
  return numbers;
}

/// The extent of a drawing's figures in their coordinates, dimension by dimension.
struct Extents {
  std::size_t dimension;
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void put(const std::vector<double>& numbers, std::size_t count, double room) {
    for (std::size_t i = 0; i < count; ++i) {
      low[i % dimension] = std::min(low[i % dimension], numbers[i] - room);
      high[i % dimension] = std::max(high[i % dimension], numbers[i] + room);
    }
  }
  /// Whether the first `count` numbers are within one more size of the figures.
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

template <class AnyFigure>
bool is_the_truth(const std::vector<AnyFigure>& figures, const std::vector<double>& numbers) {
  return std::any_of(figures.begin(), figures.end(),
                     [&](const AnyFigure& figure) { return figure.answer && figure.numbers == numbers; });
}

void draw_in_the_plane(Drawing& drawing, const Json& answer) {
  struct Drawn {
    const char* field;
    Figure::Kind kind;
    std::size_t numbers;
  };
  Extents extents{2};
  for (const Figure& figure : drawing.figures) {
    const bool circle = figure.kind == Figure::Kind::circle;
    extents.put(figure.numbers, circle ? 2 : figure.numbers.size(), circle ? figure.numbers[2] : 0);
  }
  for (const Drawn& drawn : {Drawn{"point", Figure::Kind::point, 2}, Drawn{"overlap", Figure::Kind::segment, 4}}) {
    if (!answer.contains(drawn.field)) continue;
    const std::vector<double> numbers = numbers_in(answer[drawn.field]);
    if (is_the_truth(drawing.figures, numbers)) return;
    if (numbers.size() == drawn.numbers && extents.near(numbers, numbers.size()))
      drawing.figures.push_back({drawn.kind, "answered", numbers, false, true});
  }
}

/// The corners that a list of indices names; empty where one is no point of the question.
std::vector<double> corners_of(const Json& indices, const Json& points) {
  std::vector<double> numbers;
  for (const Json& index : indices) {
    if (!index.is_number()) return {};
    const double at = index.get<double>();
    if (!(at >= 0 && at < static_cast<double>(points.size()))) return {};
    const std::vector<double> point = numbers_in(points[static_cast<std::size_t>(at)]);
    if (point.size() != 2) return {};
    numbers.insert(numbers.end(), point.begin(), point.end());
  }
  return numbers;
}

/// Pieces of a polygon, and a hull, are answered as lists of the question's points.
void draw_indices(Drawing& drawing, const Json& answer, const Json& input) {
  const char* const of = input.contains("polygon") ? "polygon" : "points";
  if (!input.contains(of) || !input[of].is_array()) return;
  std::vector<std::vector<double>> rings;
  for (const char* field : {"triangles", "pieces"}) {
    if (!answer.contains(field) || !answer[field].is_array()) continue;
    for (const Json& piece : answer[field])
      rings.push_back(piece.is_array() ? corners_of(piece, input[of]) : std::vector<double>());
  }
  if (answer.contains("polygon") && answer["polygon"].is_array())
    rings.push_back(corners_of(answer["polygon"], input[of]));
  for (std::vector<double>& ring : rings) {
    if (ring.size() >= 4) drawing.figures.push_back({Figure::Kind::polygon, "answered", std::move(ring), false, true});
  }
  if (answer.contains("segment") && answer["segment"].is_array()) {
    std::vector<double> ends = corners_of(answer["segment"], input[of]);
    if (ends.size() == 4) drawing.figures.push_back({Figure::Kind::segment, "answered", std::move(ends), false, true});
  }
}

void draw_in_space(Drawing& drawing, const Json& answer) {
  using Kind = SpaceFigure::Kind;
  struct Drawn {
    const char* field;
    Kind kind;
    std::size_t numbers;
  };
  Extents extents{3};
  std::vector<SpaceFigure> answered;
  for (const SpaceFigure& figure : drawing.space) {
    const bool sphere = figure.kind == Kind::sphere;
    if (figure.kind != Kind::plane)
      extents.put(figure.numbers, sphere ? 3 : figure.numbers.size(), sphere ? figure.numbers[3] : 0);
    // A vector stands where the truth's does.
    if (!figure.answer || figure.kind != Kind::arrow || !answer.contains(figure.label)) continue;
    const std::vector<double> vector = numbers_in(answer[figure.label]);
    if (vector.size() != 3) continue;
    std::vector<double> numbers = figure.numbers;
    for (std::size_t i = 0; i < 3; ++i) numbers[i + 3] = numbers[i] + vector[i];
    answered.push_back({Kind::arrow, "answered", std::move(numbers), {}, false, true});
  }
  for (const Drawn& drawn :
       {Drawn{"point", Kind::point, 3}, Drawn{"overlap", Kind::segment, 6}, Drawn{"segment", Kind::segment, 6},
        Drawn{"sphere", Kind::sphere, 4}, Drawn{"aabb", Kind::box, 6}}) {
    if (!answer.contains(drawn.field)) continue;
    std::vector<double> numbers = numbers_in(answer[drawn.field]);
    if (numbers.size() == drawn.numbers)
      answered.push_back({drawn.kind, "answered", std::move(numbers), {}, false, true});
  }
  for (SpaceFigure& figure : answered) {
    const std::size_t coordinates = figure.kind == Kind::sphere ? 3 : figure.numbers.size();
    if (!is_the_truth(drawing.space, figure.numbers) && extents.near(figure.numbers, coordinates))
      drawing.space.push_back(std::move(figure));
  }
}

}  // namespace

void draw_answered(Drawing& drawing, const Json& answer, const Json& input) {
  if (!answer.is_object()) return;
  if (!drawing.figures.empty()) {
    draw_in_the_plane(drawing, answer);
    if (input.is_object()) draw_indices(drawing, answer, input);
    return;
  }
  if (!drawing.space.empty()) draw_in_space(drawing, answer);
}

}  // namespace touchstone::audit
