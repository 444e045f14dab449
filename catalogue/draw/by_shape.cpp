// SPDX-License-Identifier: Apache-2.0
#include "catalogue/draw/by_shape.h"

#include <map>

#include "catalogue/draw/figures.h"
#include "geometry/bodies.h"
#include "geometry/capsules.h"
#include "geometry/rays.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue {

/// The rows of a matrix are not vectors of space.
static void draw(Drawing& drawing, const std::string& label, const Inertiad& inertia, bool) {
  const auto row = [](const Vector3d& v) { return in_words(Point3d{v.x, v.y, v.z}); };
  drawing.notes.push_back(label + ": " + row(inertia.x) + ", " + row(inertia.y) + ", " + row(inertia.z));
}

namespace {

using Draw = void (*)(Drawing&, const std::string& label, Cursor<double>& from, bool answer);

template <class T>
void draw_as(Drawing& drawing, const std::string& label, Cursor<double>& from, bool answer) {
  T value{};
  unpack(value, from, as_it_is);
  draw(drawing, label, value, answer);
}

/// Values of these types and lists of them, by their shapes.
template <class... T>
std::map<const Shape*, Draw> figures_of() {
  return {{&shape_of<T>(), draw_as<T>}..., {&shape_of<std::vector<T>>(), draw_as<std::vector<T>>}...};
}

Draw figure_of(const Shape& shape) {
  static const std::map<const Shape*, Draw> figures =
      figures_of<Point2d, Vector2d, Segment2d, Line2d, ParametricLine2d, Ray2d, Polygon2d, Region2d, Circle2d, Aabb2d,
                 Point3d, Vector3d, Plane3d, Polygon3d, Aabb3d, Sphere3d, Meshd, Obb3d, Slabd, Segment3d, Triangle3d,
                 Capsule3d, Ray3d, Inertiad>();
  const auto found = figures.find(&shape);
  return found == figures.end() ? nullptr : found->second;
}

void draw_value(Drawing& drawing, const Shape& shape, const std::string& label, Cursor<double>& at) {
  if (draw_figure(drawing, shape, label, at, false)) return;
  switch (shape.kind) {
    case Shape::Kind::number: return draw(drawing, label, *at.number++, false);
    case Shape::Kind::word: drawing.notes.push_back(label + ": " + shape.words[*at.word++]); return;
    case Shape::Kind::flag: drawing.notes.push_back(label + (*at.word++ != 0 ? ": true" : ": false")); return;
    case Shape::Kind::index: drawing.notes.push_back(label + ": " + std::to_string(*at.word++)); return;
    case Shape::Kind::optional:
      if (*at.word++ != 0) draw_value(drawing, *shape.parts[0].shape, label, at);
      return;
    case Shape::Kind::list: {
      const Word length = *at.word++;
      for (Word i = 0; i < length; ++i)
        draw_value(drawing, *shape.parts[0].shape, label + "[" + std::to_string(i) + "]", at);
      return;
    }
    case Shape::Kind::choice: {
      const Word which = *at.word++;
      return draw_value(drawing, *shape.parts[which].shape, label, at);
    }
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) draw_value(drawing, *part.shape, part.name, at);
  }
}

}  // namespace

bool has_figure(const Shape& shape) { return figure_of(shape) != nullptr; }

bool draw_figure(Drawing& drawing, const Shape& shape, const std::string& label, Cursor<double>& from, bool answer) {
  const Draw figure = figure_of(shape);
  if (figure != nullptr) figure(drawing, label, from, answer);
  return figure != nullptr;
}

void draw_question(Drawing& drawing, const Shape& shape, const Question& question) {
  Cursor<double> at(question);
  draw_value(drawing, shape, "", at);
}

}  // namespace touchstone::catalogue
