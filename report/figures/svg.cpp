// SPDX-License-Identifier: Apache-2.0
#include "report/figures/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/figures/axes.h"
#include "report/figures/near_miss.h"
#include "report/figures/strokes.h"

namespace touchstone::report {
namespace {

constexpr double left_room = 64, bottom_room = 44, top_room = 8, between_frames = 40, right_room = 10;
constexpr Frame main_frame{400, 300}, inset_frame{300, 300};
constexpr int inset_in_gaps = 4;
constexpr double thicknesses[] = {4, 2, 1.4, 1};  // of the parts of the question, in order

/// One frame with its figures; a nested svg element clips them.
std::string framed(const Drawing& drawing, const Viewport& view, const std::string& below) {
  Strokes strokes;
  std::size_t part = 0;
  std::string list;
  const bool searched = std::any_of(drawing.figures.begin(), drawing.figures.end(),
                                    [](const Figure& figure) { return figure.node.has_value(); });
  for (const Figure& figure : drawing.figures) {
    if (figure.answer || figure.said) continue;
    if (figure.node) {
      stroke(strokes, figure, view, {"node", std::max(0.5, 1.2 - 0.2 * figure.node->depth), false});
      continue;
    }
    if (figure.label.empty()) {
      stroke(strokes, figure, view, {"aid", 1.2});
      continue;
    }
    // The elements of a list, "points[0]" and so on, look alike.
    const std::size_t bracket = figure.label.find('[');
    const bool same_list = bracket != std::string::npos && figure.label.compare(0, bracket, list) == 0;
    if (!same_list) ++part;
    list = bracket == std::string::npos ? "" : figure.label.substr(0, bracket);
    const std::size_t style = (part - 1) % std::size(thicknesses);
    stroke(strokes, figure, view, {"q" + std::to_string(style), thicknesses[style], !searched});
  }
  for (const Figure& figure : drawing.figures) {
    if (figure.answer || figure.said) stroke(strokes, figure, view, {figure.said ? "said" : "truth", 1.4, !searched});
  }
  const Frame& frame = view.frame();
  return fmt::format(
      "<rect class=\"frame\" width=\"{0}\" height=\"{1}\"/><svg width=\"{0}\" height=\"{1}\">{2}{3}{4}{5}</svg>",
      pixels(frame.width), pixels(frame.height), below, strokes.lines, strokes.points,
      placed_labels(strokes.wishes, strokes.drawn, frame));
}

/// Removes figures that have a point beyond the range of doubles: a ray's second point may overflow, and so may a
/// formula's answer.
Drawing drawable(const Drawing& drawing) {
  Drawing kept;
  for (const Figure& figure : drawing.figures) {
    const bool finite =
        std::all_of(figure.numbers.begin(), figure.numbers.end(), [](double x) { return std::isfinite(x); });
    if (finite && !figure.numbers.empty()) kept.figures.push_back(figure);
  }
  return kept;
}

Viewport whole_view(const Drawing& drawing) {
  std::vector<ExactPoint> points;
  bool equal = false;
  for (const Figure& figure : drawing.figures) {
    const std::vector<ExactPoint> vertices = vertices_of(figure);
    if (figure.kind == Figure::Kind::circle) {
      equal = true;
      const mpq_class r = exact_point(figure.numbers[2], 0).x;
      points.push_back({mpq_class(vertices[0].x - r), mpq_class(vertices[0].y - r)});
      points.push_back({mpq_class(vertices[0].x + r), mpq_class(vertices[0].y + r)});
    } else {
      points.insert(points.end(), vertices.begin(), vertices.end());
    }
  }
  return Viewport::fitted(points, main_frame, equal);
}

std::string stretch_in_words(const Viewport& view) {
  if (!view.stretched()) return "";
  const mpq_class ratio = view.pixels_per_unit_y() / view.pixels_per_unit_x();
  return ratio > 1 ? "y stretched " + about(ratio, 2) + " times"
                   : "x stretched " + about(mpq_class(1 / ratio), 2) + " times";
}

std::string caption(const Frame& frame, const std::string& text) {
  if (text.empty()) return "";
  return fmt::format("<text class=\"caption\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                     pixels(frame.width / 2), pixels(frame.height + 35), escaped(text));
}

/// Half the width of the magnified frame: a few gaps, including the nearest doubles if those are near enough.
mpq_class inset_half(const NearMiss& miss) {
  const mpq_class gaps = inset_in_gaps * miss.gap;
  const auto spacing = [](double at) {
    return mpq_class(exact_point(std::nextafter(std::abs(at), 1e308), 0).x - exact_point(std::abs(at), 0).x);
  };
  const mpq_class x = abs(spacing(miss.x)), y = abs(spacing(miss.y));
  const mpq_class doubles = mpq_class(5, 2) * (x < y ? y : x);
  return gaps >= doubles || 8 * gaps < doubles ? gaps : doubles;
}

std::string opened(const std::string& style, double width, double height, const std::string& title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig{3}\" role=\"img\" viewBox=\"0 0 {0} {1}\" "
      "width=\"{0}\" height=\"{1}\"><title>{2}</title>",
      pixels(width), pixels(height), escaped(title), style);
}

constexpr double high = top_room + main_frame.height + bottom_room;

/// Lines from the position of the gap to the right, where the lens begins.
std::string rays_to_lens(const Viewport& whole, const NearMiss& miss) {
  const Pixel at = whole.at(miss.vertex);
  const double x = left_room + at.x, y = top_room + at.y, start = left_room + main_frame.width + between_frames;
  return fmt::format(
      "<path class=\"lens\" d=\"M{0} {1}h12v12h-12z\"/><path class=\"lens to-lens\" d=\"M{2} {1}L{3} {4}M{2} {5}L{3} "
      "{6}\"/>",
      pixels(x - 6), pixels(y - 6), pixels(x + 6), pixels(start), pixels(top_room), pixels(y + 6),
      pixels(top_room + inset_frame.height));
}

std::string magnified(const Drawing& drawing, const NearMiss& miss) {
  const Viewport view = Viewport::around(miss.vertex, inset_half(miss), inset_frame);
  const DoubleGrid grid = double_grid(view, miss.x, miss.y);
  const mpq_class width = view.far_corner().x - view.corner().x;
  const std::string words = "around " + (miss.label.empty() ? "the vertex" : miss.label) + ", " + about(width) +
                            " wide; gap " + about(miss.gap);
  return view_opening + opened(" magnified", inset_frame.width + right_room, high, words) +
         fmt::format("<g transform=\"translate(0 {})\">", pixels(top_room)) + framed(drawing, view, grid.svg) +
         fmt::format("<text class=\"scale\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                     pixels(inset_frame.width / 2), pixels(inset_frame.height + 17), escaped(words)) +
         caption(inset_frame, grid.caption) + "</g></svg></div>";
}

}  // namespace

std::string figure_style() {
  return ".fig{font:12px/1.2 ui-sans-serif,system-ui,sans-serif;max-width:100%;height:auto;display:block}"
         ".fig .frame{fill:var(--paper,#fff);stroke:var(--faint,#b9c0c8)}"
         ".fig .tick{stroke:var(--faint,#b9c0c8);fill:none}"
         ".fig .scale,.fig .caption{fill:var(--quiet,#59636e);font-size:11px}"
         ".fig .double{stroke:var(--faint,#b9c0c8);stroke-width:.8;fill:none}"
         ".with-lens{display:flex;flex-wrap:wrap}.with-lens .view{flex:0 1 auto;min-width:0}"
         ".fig .lens{stroke:var(--quiet,#59636e);stroke-width:.8;stroke-dasharray:2 3;fill:none}"
         ".fig .stroke{fill:none}.fig .dot{stroke:var(--paper,#fff);stroke-width:1.2}"
         ".fig .aid{--c:var(--quiet,#59636e)}.fig .node{--c:var(--q2,#2c7347)}.fig .node.face{fill:var(--c);"
         "fill-opacity:.09}.fig .q0{--c:var(--q0,#1d5fa6)}.fig .q1{--c:var(--q1,#a4510c)}.fig "
         ".q2{--c:var(--q2,#2c7347)}.fig "
         ".q3{--c:var(--q3,#7a3f98)}"
         ".fig .truth{--c:var(--truth,#c2186b)}.fig .said{--c:var(--said,#0b7a75)}.fig .stroke{stroke:var(--c)}.fig "
         ".dot,.fig .head,.fig text.q0,.fig "
         "text.q1,"
         ".fig text.q2,.fig text.q3,.fig text.said,.fig text.truth{fill:var(--c)}"
         ".fig text.q0,.fig text.q1,.fig text.q2,.fig text.q3,.fig text.said,.fig "
         "text.truth{font-weight:600;paint-order:stroke;"
         "stroke:var(--paper,#fff);stroke-width:3px;stroke-linejoin:round}"
         ".fig .ring{fill:none;stroke:var(--c);stroke-width:2;stroke-dasharray:3 2}"
         ".fig .truth.stroke{stroke-width:6;stroke-dasharray:8 6;stroke-opacity:.7}";
}

std::string drawing_svg(const Drawing& given, const std::string& title, const std::optional<mpq_class>& least_gap) {
  const Drawing drawing = drawable(given);
  if (drawing.figures.empty()) return "";
  const Viewport whole = whole_view(drawing);
  const auto miss = least_gap ? narrowest_gap(drawing, whole, *least_gap) : std::nullopt;
  const std::string svg = view_opening +
                          opened("", left_room + main_frame.width + (miss ? between_frames : right_room), high, title) +
                          fmt::format("<g transform=\"translate({} {})\">", pixels(left_room), pixels(top_room)) +
                          framed(drawing, whole, "") + ticks(whole) + caption(main_frame, stretch_in_words(whole)) +
                          "</g>" + (miss ? rays_to_lens(whole, *miss) : "") + "</svg></div>";
  return miss ? "<div class=\"with-lens\">" + svg + magnified(drawing, *miss) + "</div>" : svg;
}

}  // namespace touchstone::report
