// SPDX-License-Identifier: Apache-2.0
#include "report/figures/space_gap.h"

#include <algorithm>

#include "catalogue/numbers/ulps.h"
#include "report/figures/root.h"

namespace touchstone::report {
namespace {

using SpaceKind = SpaceFigure::Kind;

constexpr int unseen = 4000;  // steps: about five pixels

SpaceVertex at(const ExactPlace& place) { return {place[0], place[1], place[2]}; }

mpq_class squared(const SpaceVector& v) { return dot(v, v); }

mpq_class clamped_to_ends(const mpq_class& t) { return t < 0 ? mpq_class(0) : t > 1 ? mpq_class(1) : t; }

/// A vertex, an edge or a triangle, with its box in steps.
struct Part {
  std::vector<SpaceVertex> ends;
  SpacePoint low, high;

  Part(std::vector<SpaceVertex> of, const SpaceScale& scale) : ends(std::move(of)) {
    low = high = scale.at({ends[0].x, ends[0].y, ends[0].z});
    for (const SpaceVertex& end : ends) {
      const SpacePoint place = scale.at({end.x, end.y, end.z});
      for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], place[i]), high[i] = std::max(high[i], place[i]);
    }
  }
  bool is_near(const Part& other) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (low[i] - other.high[i] > unseen || other.low[i] - high[i] > unseen) return false;
    }
    return true;
  }
};

/// The parts of a figure, or a ball or a plane.
struct Solid {
  const SpaceFigure* figure;
  std::vector<Part> parts;
  bool ball = false, plane = false;

  Solid(const SpaceFigure& of, const SpaceScale& scale) : figure(&of) {
    ball = of.kind == SpaceKind::sphere && of.numbers[3] != 0;
    plane = of.kind == SpaceKind::plane;
    if (ball || plane) return;
    for (const SpaceVertex& vertex : vertices_of(of)) parts.push_back({{vertex}, scale});
    if (of.kind == SpaceKind::segment) parts.push_back({vertices_of(of), scale});
    for (const auto& ring : faces_of(of)) {
      for (std::size_t i = 0; i < ring.size(); ++i) parts.push_back({{ring[i], ring[(i + 1) % ring.size()]}, scale});
      // A polygon of more corners need not be flat, nor convex.
      if (ring.size() > 3 && of.kind == SpaceKind::polygon) continue;
      for (std::size_t i = 2; i < ring.size(); ++i) parts.push_back({{ring[0], ring[i - 1], ring[i]}, scale});
    }
  }
};

/// The point of an edge, or of a triangle's inside, that is nearest to p; for a triangle nullopt if that is on its rim.
std::optional<SpaceVertex> nearest(const Part& part, const SpaceVertex& p) {
  const std::vector<SpaceVertex>& ends = part.ends;
  if (ends.size() == 1) return ends[0];
  const SpaceVector u = ends[1] - ends[0], from = p - ends[0];
  if (ends.size() == 2) {
    const mpq_class square = squared(u);
    if (sgn(square) == 0) return ends[0];
    return ends[0] + clamped_to_ends(mpq_class(dot(from, u) / square)) * u;
  }
  const SpaceVector normal = cross(u, ends[2] - ends[0]);
  const mpq_class square = squared(normal);
  if (sgn(square) == 0) return std::nullopt;
  const SpaceVertex foot = p + mpq_class(-dot(from, normal) / square) * normal;
  for (std::size_t i = 0; i < 3; ++i) {
    if (sgn(dot(cross(ends[(i + 1) % 3] - ends[i], foot - ends[i]), normal)) < 0) return std::nullopt;
  }
  return foot;
}

/// The nearest points of two edges that are not parallel; nullopt if one is beyond an end.
std::optional<std::pair<SpaceVertex, SpaceVertex>> nearest(const Part& a, const Part& b) {
  const SpaceVector u = a.ends[1] - a.ends[0], v = b.ends[1] - b.ends[0], w = b.ends[0] - a.ends[0];
  const SpaceVector normal = cross(u, v);
  const mpq_class square = squared(normal);
  if (sgn(square) == 0) return std::nullopt;
  const mpq_class s = dot(cross(w, v), normal) / square, t = dot(cross(w, u), normal) / square;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return std::pair{a.ends[0] + s * u, b.ends[0] + t * v};
}

class Search {
 public:
  Search(const SpaceScale& scale, const mpq_class& least) : scale_(scale), least_gap_(least * least) {}

  void between(const Solid& a, const Solid& b) {
    label_ = a.figure->label;
    if (a.plane && b.plane) return;
    if (a.plane || (b.ball && !a.ball)) return between(b, a);
    if (b.plane) return to_plane(a, *b.figure);
    if (a.ball && b.ball) return two_balls(*a.figure, *b.figure);
    if (a.ball) return from_ball(*a.figure, b);
    for (const Part& p : a.parts) {
      for (const Part& q : b.parts) {
        if (&p != &q && p.is_near(q)) between(p, q);
      }
    }
  }
  std::optional<SpaceGap> found() const { return found_; }

 private:
  void between(const Part& p, const Part& q) {
    if (p.ends.size() == 1) {
      if (const auto other = nearest(q, p.ends[0])) offer(p.ends[0], *other - p.ends[0]);
    } else if (q.ends.size() == 1) {
      if (const auto own = nearest(p, q.ends[0])) offer(*own, q.ends[0] - *own);
    } else if (p.ends.size() == 2 && q.ends.size() == 2) {
      if (const auto both = nearest(p, q)) offer(both->first, both->second - both->first);
    }
  }
  void to_plane(const Solid& solid, const SpaceFigure& plane) {
    const SpaceVector normal{exact_value(plane.numbers[0]), exact_value(plane.numbers[1]),
                             exact_value(plane.numbers[2])};
    const auto to_foot = [&](const SpaceVertex& p) {
      const mpq_class height = normal.x * p.x + normal.y * p.y + normal.z * p.z + exact_value(plane.numbers[3]);
      return mpq_class(-height / squared(normal)) * normal;
    };
    for (const SpaceVertex& p : vertices_of(*solid.figure)) {
      const SpaceVector displacement = to_foot(p);
      solid.ball ? round(p + displacement, displacement, radius_of(*solid.figure), normal) : offer(p, displacement);
    }
  }
  void two_balls(const SpaceFigure& a, const SpaceFigure& b) {
    const SpaceVertex centre = vertices_of(a)[0];
    const SpaceVector displacement = vertices_of(b)[0] - centre;
    const mpq_class radii = radius_of(a) + radius_of(b);
    round(centre + mpq_class(radius_of(a) / radii) * displacement, displacement, radii, displacement);
  }
  void from_ball(const SpaceFigure& ball, const Solid& solid) {
    const SpaceVertex centre = vertices_of(ball)[0];
    for (const Part& part : solid.parts) {
      if (const auto place = nearest(part, centre)) round(*place, *place - centre, radius_of(ball), *place - centre);
    }
  }

  /// |way| - radius to first order in itself: used only if it is small compared with the radius.
  void round(const SpaceVertex& place, const SpaceVector& displacement, const mpq_class& radius,
             const SpaceVector& along) {
    const mpq_class gap = (squared(displacement) - radius * radius) / (2 * radius),
                    steps = gap * scale_.steps_per_unit[0];
    consider(place, along, mpq_class(gap * gap), mpq_class(steps * steps));
  }
  void offer(const SpaceVertex& place, const SpaceVector& displacement) {
    const auto& per_unit = scale_.steps_per_unit;
    const SpaceVector steps{mpq_class(displacement.x * per_unit[0]), mpq_class(displacement.y * per_unit[1]),
                            mpq_class(displacement.z * per_unit[2])};
    consider(place, displacement, squared(displacement), squared(steps));
  }
  void consider(const SpaceVertex& place, const SpaceVector& along, const mpq_class& gap, const mpq_class& steps) {
    // Without a direction along the gap, such as for a point in a ball's center, no lens shows it.
    if (sgn(gap) == 0 || sgn(squared(along)) == 0 || steps >= narrowest_ || gap < least_gap_) return;
    narrowest_ = steps;
    found_ = SpaceGap{place, along, label_, root(gap)};
  }

  const SpaceScale& scale_;
  mpq_class least_gap_, narrowest_ = mpq_class(unseen) * unseen;
  std::string label_;
  std::optional<SpaceGap> found_;
};

/// True for an oriented box, drawn by eight corners some of which were rounded: their gaps are not those of the
/// question.
bool has_rounded_corners(const SpaceFigure& figure) {
  const std::vector<SpaceVertex> v = vertices_of(figure);
  if (figure.kind != SpaceKind::mesh || v.size() != 8 || figure.faces.empty() || figure.faces[0].size() != 4)
    return false;
  const auto differ = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const SpaceVector first = v[a] - v[b], second = v[c] - v[d];
    return first.x != second.x || first.y != second.y || first.z != second.z;
  };
  return differ(1, 0, 3, 2) || differ(1, 0, 5, 4) || differ(1, 0, 7, 6) || differ(2, 0, 6, 4) || differ(4, 0, 6, 2);
}

/// Auxiliary figures do not decide, nor do vectors, which have no position of their own, nor figures that were computed
/// for the drawing: the truth, and the motion by an answer.
bool decides(const SpaceFigure& figure) {
  const bool computed = (figure.answer && !figure.said) || figure.label.rfind("answered: ", 0) == 0;
  return !figure.label.empty() && figure.kind != SpaceKind::arrow && !computed && !has_rounded_corners(figure);
}

}  // namespace

std::vector<SpaceVertex> vertices_of(const SpaceFigure& figure) {
  std::vector<SpaceVertex> vertices;
  const std::vector<ExactPlace> places = places_of(figure);
  if (figure.kind != SpaceKind::box) {
    for (const ExactPlace& place : places) vertices.push_back(at(place));
    return vertices;
  }
  for (std::size_t corner = 0; corner < 8; ++corner)
    vertices.push_back({places[corner & 1][0], places[corner >> 1 & 1][1], places[corner >> 2 & 1][2]});
  return vertices;
}

std::vector<std::vector<SpaceVertex>> faces_of(const SpaceFigure& figure) {
  const std::vector<SpaceVertex> vertices = vertices_of(figure);
  if (figure.kind == SpaceKind::polygon) return {vertices};
  std::vector<std::vector<std::uint32_t>> indices;
  if (figure.kind == SpaceKind::mesh) indices = figure.faces;
  if (figure.kind == SpaceKind::box)
    indices = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  std::vector<std::vector<SpaceVertex>> rings;
  for (const auto& face : indices) {
    if (std::any_of(face.begin(), face.end(), [&](std::uint32_t i) { return i >= vertices.size(); })) continue;
    std::vector<SpaceVertex> ring;
    for (const std::uint32_t i : face) ring.push_back(vertices[i]);
    if (!ring.empty()) rings.push_back(std::move(ring));
  }
  return rings;
}

mpq_class length_of(const SpaceVector& v) { return root(squared(v)); }

std::optional<SpaceGap> narrowest_gap(const std::vector<SpaceFigure>& figures, const SpaceScale& scale,
                                      const mpq_class& least) {
  std::vector<Solid> solids;
  for (const SpaceFigure& figure : figures) {
    if (decides(figure)) solids.emplace_back(figure, scale);
  }
  Search search(scale, least);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const SpaceKind kind = solids[i].figure->kind;
    if (kind == SpaceKind::polygon || kind == SpaceKind::mesh) search.between(solids[i], solids[i]);
    for (std::size_t j = i + 1; j < solids.size(); ++j) search.between(solids[i], solids[j]);
  }
  return search.found();
}

}  // namespace touchstone::report
