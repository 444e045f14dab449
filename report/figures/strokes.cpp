// SPDX-License-Identifier: Apache-2.0
#include "report/figures/strokes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/figures/near_miss.h"

namespace touchstone::report {
namespace {

constexpr double margin = 8, arrow_length = 11, greatest_drawn_radius = 4000, text_spacing = 5;

void mark_drawn(Strokes& strokes, const Pixel& a, const Pixel& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const int steps = static_cast<int>(std::min(length, 2000.0) / text_spacing) + 1;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    strokes.drawn.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
  }
}

void dot(Strokes& strokes, const Pixel& p, const Style& style, bool ring, double scale = 1) {
  const double radius = ring ? 9 : scale * (2.6 + 0.8 * style.thickness);
  strokes.points += fmt::format("<circle class=\"{} {}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>", style.name,
                                ring ? "ring" : "dot", pixels(p.x), pixels(p.y), pixels(radius));
  for (const double dy : {-1.0, 0.0, 1.0}) {
    for (const double dx : {-1.0, 0.0, 1.0}) strokes.drawn.push_back({p.x + radius * dx, p.y + radius * dy});
  }
}

std::string path(const Style& style, const std::string& course) {
  return fmt::format("<path class=\"{} stroke\" stroke-width=\"{}\" d=\"{}\"/>", style.name, pixels(style.thickness),
                     course);
}

std::string course(const Pixel& a, const Pixel& b) {
  return "M" + pixels(a.x) + " " + pixels(a.y) + "L" + pixels(b.x) + " " + pixels(b.y);
}

void wish(Strokes& strokes, const Figure& figure, const Style& style, std::vector<Pixel> places) {
  if (figure.label.empty() || places.empty()) return;
  strokes.wishes.push_back({std::move(places), figure.answer ? "truth: " + figure.label : figure.label, style.name});
}

void arrowhead(Strokes& strokes, const Pixel& from, const Pixel& tip, const Style& style) {
  const double length = std::hypot(tip.x - from.x, tip.y - from.y);
  if (length < 4) return;
  const double ux = (tip.x - from.x) / length, uy = (tip.y - from.y) / length, back = std::min(arrow_length, length);
  const Pixel base{tip.x - back * ux, tip.y - back * uy};
  strokes.points += fmt::format("<path class=\"{} head\" d=\"M{} {}L{} {}L{} {}Z\"/>", style.name, pixels(tip.x),
                                pixels(tip.y), pixels(base.x - back * 0.4 * uy), pixels(base.y + back * 0.4 * ux),
                                pixels(base.x + back * 0.4 * uy), pixels(base.y - back * 0.4 * ux));
}

void straight(Strokes& strokes, const Figure& figure, const Viewport& view, const Style& style) {
  const std::vector<ExactPoint> ends = vertices_of(figure);
  const bool ray = figure.kind == Figure::Kind::ray, line = figure.kind == Figure::Kind::line;
  const std::vector<Pixel> seen = clipped(view, ends[0], ends[1], {line, line || ray}, margin);
  std::vector<Pixel> places;
  if (!seen.empty()) {
    strokes.lines += path(style, course(seen[0], seen[1]));
    mark_drawn(strokes, seen[0], seen[1]);
    for (const double t : {0.5, 0.3, 0.7, 0.85, 0.15}) {
      places.push_back({seen[0].x + t * (seen[1].x - seen[0].x), seen[0].y + t * (seen[1].y - seen[0].y)});
    }
  }
  // A ray leaves the frame; its head is drawn just inside.
  if (ray && !seen.empty()) {
    const std::vector<Pixel> inner = clipped(view, ends[0], ends[1], {false, true}, -1);
    if (!inner.empty()) arrowhead(strokes, inner[0], inner[1], style);
  } else if (figure.kind == Figure::Kind::arrow && view.shows(ends[1])) {
    arrowhead(strokes, view.at(ends[0]), view.at(ends[1]), style);
  }
  const bool tip_is_dot = figure.kind == Figure::Kind::segment || line;
  for (std::size_t i = 0; i < (tip_is_dot ? 2u : 1u); ++i) {
    if (view.shows(ends[i]) && !figure.label.empty()) dot(strokes, view.at(ends[i]), style, false);
    if (seen.empty() && view.shows(ends[i])) places.push_back(view.at(ends[i]));
  }
  const bool nothing = figure.kind == Figure::Kind::arrow && ends[0].x == ends[1].x && ends[0].y == ends[1].y;
  if (!nothing) wish(strokes, figure, style, places);
}

/// A circle too large for a browser is, within the frame, a parabola next to its tangent.
void large_circle(Strokes& strokes, const ExactPoint& centre, const mpq_class& radius, const Viewport& view,
                  const Style& style) {
  const ExactPoint c = view.exactly(centre);
  const mpq_class dx = mpq_class(view.frame().width / 2) - c.x, dy = mpq_class(view.frame().height / 2) - c.y;
  const mpq_class gap = (dx * dx + dy * dy - radius * radius) / (2 * radius);
  const double reach = view.frame().width + view.frame().height;
  const mpq_class size = abs(dx) > abs(dy) ? mpq_class(abs(dx)) : mpq_class(abs(dy));
  if (abs(gap) > reach || sgn(size) == 0) return;
  const double x = mpq_class(dx / size).get_d(), y = mpq_class(dy / size).get_d(), length = std::hypot(x, y);
  const double ux = x / length, uy = y / length, off = gap.get_d(), r = radius > 1e300 ? 1e300 : radius.get_d();
  constexpr int steps = 48;
  std::string arc;
  Pixel before{};
  for (int i = 0; i <= steps; ++i) {
    const double s = reach * (2.0 * i / steps - 1), sag = s * s / (2 * r);
    const Pixel p{view.frame().width / 2 - (off + sag) * ux - s * uy,
                  view.frame().height / 2 - (off + sag) * uy + s * ux};
    arc += (i == 0 ? "M" : "L") + pixels(p.x) + " " + pixels(p.y);
    if (i > 0) mark_drawn(strokes, before, p);
    before = p;
  }
  strokes.lines += path(style, arc);
}

void circle(Strokes& strokes, const Figure& figure, const Viewport& view, const Style& style) {
  const ExactPoint centre = vertices_of(figure)[0];
  const mpq_class radius = exact_point(figure.numbers[2], 0).x * view.pixels_per_unit_x();
  const bool seen = view.shows(centre);
  const Pixel c = view.at(centre);
  if (seen) dot(strokes, c, style, false, sgn(radius) == 0 ? 1 : 0.4);
  std::vector<Pixel> places;
  if (radius > greatest_drawn_radius) {
    large_circle(strokes, centre, radius, view, style);
  } else if (sgn(radius) > 0) {
    const double r = radius.get_d();
    strokes.lines += fmt::format("<circle class=\"{} stroke\" stroke-width=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
                                 style.name, pixels(style.thickness), pixels(c.x), pixels(c.y), pixels(r));
    constexpr double diagonal = 0.70710678118654752;
    for (const Pixel displacement :
         {Pixel{diagonal, -diagonal}, {-diagonal, -diagonal}, {diagonal, diagonal}, {-diagonal, diagonal}}) {
      places.push_back({c.x + r * displacement.x, c.y + r * displacement.y});
    }
    constexpr int steps = 72;
    for (int i = 0; i < steps; ++i) {
      const double angle = 6.283185307179586 * i / steps;
      strokes.drawn.push_back({c.x + r * std::cos(angle), c.y + r * std::sin(angle)});
    }
  }
  if (seen) places.push_back(c);
  wish(strokes, figure, style, places);
}

/// The inside of a node that a search entered, which is filled.
void fill(Strokes& strokes, const std::vector<ExactPoint>& vertices, const Viewport& view, const Style& style) {
  std::string outline;
  for (const ExactPoint& vertex : vertices) {
    const Pixel p = view.at(vertex);
    outline += (outline.empty() ? "M" : "L") + pixels(p.x) + " " + pixels(p.y);
  }
  strokes.lines += fmt::format("<path class=\"{} face\" d=\"{}Z\"/>", style.name, outline);
}

void polygon(Strokes& strokes, const Figure& figure, const Viewport& view, const Style& style) {
  const std::vector<ExactPoint> vertices = vertices_of(figure);
  if (figure.node && figure.node->entered) fill(strokes, vertices, view, style);
  // A figure reduced to a point would be invisible.
  const bool is_point = std::all_of(vertices.begin(), vertices.end(),
                                    [&](const ExactPoint& p) { return p.x == vertices[0].x && p.y == vertices[0].y; });
  const bool corners = style.corners || (is_point && !figure.node);
  std::vector<Pixel> places, further;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const ExactPoint& next = vertices[(i + 1) % vertices.size()];
    const std::vector<Pixel> seen = clipped(view, vertices[i], next, {}, margin);
    if (!seen.empty()) {
      strokes.lines += path(style, course(seen[0], seen[1]));
      mark_drawn(strokes, seen[0], seen[1]);
      const auto part = [&seen](double t) {
        return Pixel{seen[0].x + t * (seen[1].x - seen[0].x), seen[0].y + t * (seen[1].y - seen[0].y)};
      };
      places.push_back(part(0.5));
      for (const double t : {0.3, 0.7, 0.15, 0.85}) further.push_back(part(t));
    }
    if (corners && view.shows(vertices[i])) dot(strokes, view.at(vertices[i]), style, false);
  }
  places.insert(places.end(), further.begin(), further.end());
  wish(strokes, figure, style, places);
}

}  // namespace

void stroke(Strokes& strokes, const Figure& figure, const Viewport& view, const Style& style) {
  switch (figure.kind) {
    case Figure::Kind::point: {
      const ExactPoint p = vertices_of(figure)[0];
      if (!view.shows(p)) return;
      dot(strokes, view.at(p), style, figure.answer);
      wish(strokes, figure, style, {view.at(p)});
      return;
    }
    case Figure::Kind::segment:
    case Figure::Kind::line:
    case Figure::Kind::ray:
    case Figure::Kind::arrow: return straight(strokes, figure, view, style);
    case Figure::Kind::circle: return circle(strokes, figure, view, style);
    case Figure::Kind::polygon: return polygon(strokes, figure, view, style);
  }
}

}  // namespace touchstone::report
