// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/common_interior.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "robust/kernel/filters/space_box.h"
#include "robust/kernel/shapes/points_in_space.h"
#include "robust/kernel/shapes/triangle_clip.h"

namespace touchstone::robust::kernel {
namespace {

using Point = Point3<mpz_class>;
using Vector = Vector3<mpz_class>;
using Segment = Segment3<mpz_class>;

Point times(const Point& p, const mpz_class& k) { return {mpz_class(k * p.x), mpz_class(k * p.y), mpz_class(k * p.z)}; }

/// A set of solids: 1 for a, 2 for b.
using Solids = unsigned;
constexpr Solids of_both = 3;

/// A face with an area; its edges lead from a corner to the next.
struct Wall {
  Triangle3<mpz_class> corners;
  std::array<Vector, 3> edges;
  Vector normal;
  std::array<Index, 3> names;
  SpaceBox box;
  Solids solid;
  bool near_other;  ///< its box meets that of the other solid

  bool has_edge_of(const Wall& other) const {
    const auto named = [&other](Index i) { return std::count(other.names.begin(), other.names.end(), i) > 0; };
    return solid == other.solid && std::count_if(names.begin(), names.end(), named) > 1;
  }
  /// True if all corners are in front of the other's plane, or behind it, or in it.
  bool on_one_side_of(const Wall& other) const {
    const auto side = [&other](const Point& p) { return sgn(dot(other.normal, p - other.corners.a)); };
    const int first = side(corners.a);
    return side(corners.b) == first && side(corners.c) == first;
  }
};

/// segment / w, w > 0, and the box around it; a part of a line.
struct Line {
  Segment segment;
  mpz_class w;
  Vector along;
  SpaceBox box;
};

/// The common part of two walls in different planes, if it is a segment.
std::optional<Line> common_line(const Wall& v, const Wall& w) {
  // Otherwise the common part is only points of edges, or has a line of its own, or several.
  if (v.has_edge_of(w) || v.on_one_side_of(w) || w.on_one_side_of(v)) return std::nullopt;
  const std::vector<HomogeneousPoint> ends = ends_of_common_part(v.corners, w.corners);
  for (const HomogeneousPoint& end : ends) {
    if (zero(displacement(ends.front(), end))) continue;
    const HomogeneousPoint& first = ends.front();
    Line line{{times(first.p, end.w), times(end.p, first.w)},
              mpz_class(first.w * end.w),
              cross(v.normal, w.normal),
              v.box.with(w.box)};
    auto& [p, q] = line.segment;
    reduce({&line.w, &p.x, &p.y, &p.z, &q.x, &q.y, &q.z}), reduce({&line.along.x, &line.along.y, &line.along.z});
    return line;
  }
  return std::nullopt;
}

/// A wall, and its corners relative to a point, times a positive number.
struct Seen {
  Seen(const Wall& seen, const HomogeneousPoint& from)
      : wall(&seen),
        corners{displacement(from, {wall->corners.a, 1}), displacement(from, {wall->corners.b, 1}),
                displacement(from, {wall->corners.c, 1})} {}
  const Wall* wall;
  std::array<Vector, 3> corners;
};

/// A half-plane bounded by a line, along which a wall leaves it.
struct Step {
  Vector away;
  Solids solid;
};

/// Adds one for a wall that has the line as an edge, two for one that the line crosses.
void add_steps(std::vector<Step>& steps, const Seen& seen, const Vector& along) {
  const auto& corners = seen.corners;
  const auto turned = [&along](const Vector& corner) { return cross(along, corner); };
  const auto first = std::find_if(corners.begin(), corners.end(), [&](const Vector& v) { return !zero(turned(v)); });
  steps.push_back({*first, seen.wall->solid});
  const auto beyond = std::find_if(
      first, corners.end(), [&, side = turned(*first)](const Vector& v) { return sgn(dot(side, turned(v))) < 0; });
  if (beyond != corners.end()) steps.push_back({*beyond, seen.wall->solid});
}

/// True if a ray crosses a wall that does not contain the point; empty if its line may meet an edge or lie in the
/// plane. An edge and the point span the same plane as a corner and the edge.
std::optional<bool> crosses(const Vector& ray, const Seen& seen) {
  const Wall& wall = *seen.wall;
  const int height = sgn(dot(wall.normal, seen.corners[0]));
  if (height == 0) {
    if (sgn(dot(ray, wall.normal)) == 0) return std::nullopt;
    return false;
  }
  std::array<int, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = sgn(dot(ray, cross(seen.corners[k], wall.edges[k])));
    if (sides[k] == 0) return std::nullopt;
  }
  return sides[0] == sides[1] && sides[1] == sides[2] && sides[0] == height;
}

/// A number strictly between two, with few bits.
Clipped::Parameter between(const Clipped::Parameter& from, const Clipped::Parameter& to) {
  for (mp_bitcnt_t bits = 1;; bits *= 2) {
    const mpz_class n = (from.numerator << bits) / from.denominator + 1, d = mpz_class(1) << bits;
    if (n * to.denominator < to.numerator * d) return {n, d};
  }
}

/// The surroundings of a point in general position on a line: half-planes, and other walls.
struct Around {
  Vector along;
  std::vector<Step> steps;
  std::vector<Seen> others;

  /// True if some sector between half-planes is inside of both, given the sector of the ray; empty if the ray is not in
  /// general position.
  std::optional<bool> any_of_both(const Vector& ray) {
    Solids inside = 0;
    for (const Seen& seen : others) {
      const auto crossed = crosses(ray, seen);
      if (!crossed) return std::nullopt;
      if (*crossed) inside ^= seen.wall->solid;
    }
    const Vector left = cross(along, ray);
    const auto half = [&left](const Step& step) { return sgn(dot(left, step.away)); };
    if (std::any_of(steps.begin(), steps.end(), [&half](const Step& step) { return half(step) == 0; }))
      return std::nullopt;
    const auto before = [&](const Step& s, const Step& t) {
      const int of_s = half(s), of_t = half(t);
      return of_s != of_t ? of_s > of_t : sgn(dot(along, cross(s.away, t.away))) > 0;
    };
    std::sort(steps.begin(), steps.end(), before);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if ((i == 0 || before(steps[i - 1], steps[i])) && inside == of_both) return true;
      inside ^= steps[i].solid;
    }
    return inside == of_both;
  }
};

class Walls {
 public:
  Walls(const Meshd& a, const Meshd& b) {
    Polygon3d all{a.vertices};
    all.vertices.insert(all.vertices.end(), b.vertices.begin(), b.vertices.end());
    const std::vector<Point> points = integers_of(all).at;
    add(a, points.data(), 1, SpaceBox::around(b)), add(b, points.data() + a.vertices.size(), 2, SpaceBox::around(a));
  }

  bool any_sector_of_both() const {
    for (const bool across : {true, false}) {  // usually some sector is inside of both where a and b cross
      for (std::size_t i = 0; i < walls_.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const Wall &v = walls_[i], &w = walls_[j];
          if ((v.solid != w.solid) != across || !v.near_other || !w.near_other || !v.box.meets(w.box)) continue;
          const auto line = common_line(v, w);
          if (line && any_of_both(*line)) return true;
        }
      }
    }
    const auto within_both = [this](const Line& edge) { return any_of_both(edge); };
    return std::any_of(edges_.begin(), edges_.end(), within_both);
  }

 private:
  void add(const Meshd& mesh, const Point* points, Solids solid, const SpaceBox& other) {
    std::set<std::pair<Index, Index>> known;
    for (const Face& f : mesh.faces) {
      const Triangle3<mpz_class> corners{points[f.a], points[f.b], points[f.c]};
      const std::array edges{corners.b - corners.a, corners.c - corners.b, corners.a - corners.c};
      Vector normal = cross(edges[0], edges[1]);
      if (zero(normal)) continue;
      reduce({&normal.x, &normal.y, &normal.z});
      const SpaceBox box = SpaceBox::around(mesh, f);
      walls_.push_back({corners, edges, normal, {f.a, f.b, f.c}, box, solid, box.meets(other)});
      for (const auto& [p, q] : {std::minmax(f.a, f.b), std::minmax(f.b, f.c), std::minmax(f.c, f.a)}) {
        const SpaceBox around = SpaceBox::around(mesh.vertices[p]).with(SpaceBox::around(mesh.vertices[q]));
        if (around.meets(other) && known.emplace(p, q).second)
          edges_.push_back({{points[p], points[q]}, 1, points[q] - points[p], around});
      }
    }
  }

  /// Tests one point in each piece of the line between the ends of walls.
  bool any_of_both(const Line& line) const {
    std::vector<Clipped> parts(walls_.size());
    std::vector<Clipped::Parameter> cuts{{0, 1}, {1, 1}};
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      parts[i].empty = !walls_[i].box.meets(line.box);
      if (!parts[i].empty) parts[i] = clipped(line.segment, walls_[i].corners, line.w);
      if (!parts[i].empty) cuts.push_back(parts[i].first), cuts.push_back(parts[i].last);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      if (cuts[k - 1] < cuts[k] && any_of_both(line, parts, cuts[k - 1], cuts[k])) return true;
    }
    return false;
  }

  bool any_of_both(const Line& line, const std::vector<Clipped>& parts, const Clipped::Parameter& from,
                   const Clipped::Parameter& to) const {
    const auto [n, d] = between(from, to);
    const mpz_class rest = d - n;
    const auto& [p, q] = line.segment;
    HomogeneousPoint inside{
        {mpz_class(rest * p.x + n * q.x), mpz_class(rest * p.y + n * q.y), mpz_class(rest * p.z + n * q.z)},
        mpz_class(d * line.w)};
    reduce({&inside.w, &inside.p.x, &inside.p.y, &inside.p.z});
    Around around{line.along, {}, {}};
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      const bool holds = !parts[i].empty && !(from < parts[i].first) && !(parts[i].last < to);
      if (holds) add_steps(around.steps, {walls_[i], inside}, around.along);
      else if (walls_[i].box.reaches(line.box)) around.others.emplace_back(walls_[i], inside);
    }
    for (std::int64_t k = 1;; ++k) {  // upwards along each axis; a plane has at most two of these directions
      if (const auto any = around.any_of_both({1, k, k * k})) return *any;
    }
  }

  std::vector<Wall> walls_;
  std::vector<Line> edges_;
};

}  // namespace

bool have_common_interior(const Meshd& a, const Meshd& b) { return Walls(a, b).any_sector_of_both(); }

}  // namespace touchstone::robust::kernel
