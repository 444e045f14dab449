// SPDX-License-Identifier: Apache-2.0
#include "report/figures/near_miss.h"

#include "report/figures/root.h"

namespace touchstone::report {
namespace {

constexpr int seen_as_apart = 5;  // pixels

/// A distance squared, in pixels and in the unit of the coordinates.
struct Gap {
  mpq_class pixels, units;
};

mpq_class squared(const mpq_class& x, const mpq_class& y) { return mpq_class(x * x + y * y); }

mpq_class between(const ExactPoint& p, const ExactPoint& q) {
  return squared(mpq_class(p.x - q.x), mpq_class(p.y - q.y));
}

/// The gap from p to the nearest part of a + t (b - a); nullopt if its foot is beyond an end.
std::optional<mpq_class> beside(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b, const Stretch& stretch) {
  const ExactPoint d{mpq_class(b.x - a.x), mpq_class(b.y - a.y)}, v{mpq_class(p.x - a.x), mpq_class(p.y - a.y)};
  const mpq_class length = squared(d.x, d.y);
  if (sgn(length) == 0) return std::nullopt;
  const mpq_class t = (v.x * d.x + v.y * d.y) / length;
  if ((t < 0 && !stretch.before) || (t > 1 && !stretch.beyond)) return std::nullopt;
  const mpq_class area = d.x * v.y - d.y * v.x;
  return mpq_class(area * area / length);
}

std::optional<Gap> gap_to(const ExactPoint& a, const ExactPoint& b, const Stretch& stretch, const ExactPoint& p,
                          const Viewport& view) {
  const auto units = beside(p, a, b, stretch);
  const auto pixels = beside(view.exactly(p), view.exactly(a), view.exactly(b), stretch);
  if (!units || !pixels) return std::nullopt;
  return Gap{*pixels, *units};
}

std::optional<Gap> gap_to(const Figure& figure, const ExactPoint& p, const Viewport& view) {
  const std::vector<ExactPoint> ends = vertices_of(figure);
  switch (figure.kind) {
    case Figure::Kind::point: return std::nullopt;
    case Figure::Kind::polygon: {
      // Touching one edge is no reason to overlook the gap to another; edges that end in p itself have none.
      std::optional<Gap> least;
      for (std::size_t i = 0; i < ends.size(); ++i) {
        const auto gap = gap_to(ends[i], ends[(i + 1) % ends.size()], {false, false}, p, view);
        if (gap && sgn(gap->units) != 0 && (!least || gap->pixels < least->pixels)) least = gap;
      }
      return least;
    }
    case Figure::Kind::circle: {
      const mpq_class r = exact_point(figure.numbers[2], 0).x;
      if (sgn(r) == 0) return std::nullopt;
      // |p - centre| - r, to first order in the gap: used only if the gap is small compared with r.
      const mpq_class gap = (between(p, ends[0]) - r * r) / (2 * r);
      const mpq_class in_pixels = gap * view.pixels_per_unit_x();
      return Gap{mpq_class(in_pixels * in_pixels), mpq_class(gap * gap)};
    }
    case Figure::Kind::segment:
    case Figure::Kind::arrow:
    case Figure::Kind::ray:
    case Figure::Kind::line: {
      const Stretch stretch{figure.kind == Figure::Kind::line,
                            figure.kind == Figure::Kind::line || figure.kind == Figure::Kind::ray};
      return gap_to(ends[0], ends[1], stretch, p, view);
    }
  }
  return std::nullopt;
}

/// Auxiliary figures do not decide: lines without a name, and vectors, which have no position of their own.
bool decides(const Figure& figure) { return !figure.label.empty() && figure.kind != Figure::Kind::arrow; }

}  // namespace

std::vector<ExactPoint> vertices_of(const Figure& figure) {
  std::vector<ExactPoint> vertices;
  const std::size_t coordinates = figure.kind == Figure::Kind::circle ? 2 : figure.numbers.size();
  for (std::size_t i = 0; i + 1 < coordinates; i += 2) {
    vertices.push_back(exact_point(figure.numbers[i], figure.numbers[i + 1]));
  }
  return vertices;
}

std::optional<NearMiss> narrowest_gap(const Drawing& drawing, const Viewport& view, const mpq_class& least_gap) {
  std::optional<NearMiss> found;
  mpq_class least = seen_as_apart * seen_as_apart;
  const auto offer = [&](const Figure& figure, std::size_t vertex, const Gap& gap) {
    if (sgn(gap.units) == 0 || gap.pixels >= least || gap.units < least_gap * least_gap) return;
    least = gap.pixels;
    const double x = figure.numbers[2 * vertex], y = figure.numbers[2 * vertex + 1];
    found = NearMiss{exact_point(x, y), x, y, figure.label, root(gap.units)};
  };
  for (const Figure& figure : drawing.figures) {
    if (!decides(figure) || figure.answer || (figure.kind == Figure::Kind::circle && figure.numbers[2] != 0)) continue;
    const std::vector<ExactPoint> vertices = vertices_of(figure);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      for (const Figure& other : drawing.figures) {
        // Answers are also compared with the truth.
        if (!decides(other) || (other.answer && !figure.said)) continue;
        if (&other != &figure || figure.kind == Figure::Kind::polygon) {
          if (const auto gap = gap_to(other, vertices[i], view)) offer(figure, i, *gap);
        }
        if (other.kind == Figure::Kind::circle && other.numbers[2] != 0) continue;
        for (const ExactPoint& vertex : vertices_of(other)) {
          offer(figure, i, {between(view.exactly(vertices[i]), view.exactly(vertex)), between(vertices[i], vertex)});
        }
      }
    }
  }
  return found;
}

}  // namespace touchstone::report
