// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/minkowski/least_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/penetration.h"
#include "robust/kernel/filters/sized.h"
#include "robust/kernel/shapes/lowest_vertices.h"
#include "robust/kernel/shapes/points_in_space.h"

namespace touchstone::robust::kernel {
namespace {

using IntegerPoint = Point3<mpz_class>;
using IntegerVector = Vector3<mpz_class>;

bool zero(const IntegerVector& v) { return sgn(v.x) == 0 && sgn(v.y) == 0 && sgn(v.z) == 0; }

/// Three displacements between vertices of one mesh that are independent, or as many as there are.
std::vector<IntegerVector> spans_of(const std::vector<const Meshd*>& meshes) {
  Polygon3d all;
  for (const Meshd* mesh : meshes)
    all.vertices.insert(all.vertices.end(), mesh->vertices.begin(), mesh->vertices.end());
  const auto at = integers_of(all).at;
  std::vector<IntegerVector> found;
  std::size_t first = 0;
  for (const Meshd* mesh : meshes) {
    for (std::size_t k = first; k < first + mesh->vertices.size(); ++k) {
      const IntegerVector span = at[k] - at[first];
      const bool wider = found.empty()       ? !zero(span)
                         : found.size() == 1 ? !zero(cross(found[0], span))
                                             : found.size() == 2 && sgn(dot(cross(found[0], found[1]), span)) != 0;
      if (wider) found.push_back(span);
    }
    first += mesh->vertices.size();
  }
  return found;
}

/// The direction at a right angle to at most two independent vectors whose unit vector is the lexicographically
/// greatest: the part of an axis at a right angle to them, of the first that has one.
IntegerVector last_across(const std::vector<IntegerVector>& spans) {
  IntegerVector found{0, 0, 0};
  for (const IntegerVector& axis : {IntegerVector{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    const IntegerVector normal = spans.size() == 2 ? cross(spans[0], spans[1]) : axis;
    found = spans.size() == 1 ? cross(spans[0], cross(axis, spans[0])) : dot(axis, normal) * normal;
    if (!zero(found)) break;
  }
  return found;
}

/// With both sides of a triangle as its faces.
Meshd with_sides(Meshd core) {
  if (is_simplex(core) && spans_of({&core}).size() == 2) core.faces = sides_of_simplex(core);
  return core;
}

/// The ends of an edge, and the third corners of both its faces. A segment's edges lead from its first vertex to the
/// others, one of which is elsewhere, and have that vertex in place of third corners.
struct Edge {
  Index from, to, left, right;
};

std::vector<Edge> edges_of(const Meshd& mesh) {
  std::map<std::pair<Index, Index>, Index> third;
  for (const auto& [a, b, c] : mesh.faces) third[{a, b}] = c, third[{b, c}] = a, third[{c, a}] = b;
  std::vector<Edge> edges;
  for (const auto& [ends, left] : third)
    if (ends.first < ends.second) edges.push_back({ends.first, ends.second, left, third.at({ends.second, ends.first})});
  for (Index to = 1; mesh.faces.empty() && to < mesh.vertices.size(); ++to) edges.push_back({0, to, 0, 0});
  return edges;
}

/// A direction that may be the one of the least overlap: of a face of a, or of b, or across an edge of each; and a
/// number that the overlap is not less than.
struct Candidate {
  enum class Kind { face_of_a, face_of_b, edges } kind;
  std::size_t i, j;
  double least;
};

/// Where a third corner of a's edge or of b's lies: 1 where the direction leaves it on the right side, -1 where the
/// opposite direction does, 0 where that is not certain.
template <class Number>
int side(const Number& of_a_not_of_b) {
  if constexpr (requires { of_a_not_of_b.positive(); })
    return static_cast<int>(of_a_not_of_b.positive()) - static_cast<int>(of_a_not_of_b.negative());
  else return sgn(of_a_not_of_b);
}

/// 1 or -1: the direction, or its opposite, is strictly between the normals of the faces of both edges, reversed for a;
/// so a begins with its edge and b ends with its own. 2: no direction is. 0: not certain. One of both has faces.
template <class Normal, class Between>
int turn_of(const Normal& normal, const Edge& e, const Edge& f, const Between& of_a, const Between& of_b) {
  int up = 0, down = 0, asked = 0;
  const auto holds = [&](int sign, const auto& between, const Edge& edge, Index third) {
    if (third == edge.from) return true;
    const int found = sign * side(dot(normal, between(edge.from, third)));
    up += static_cast<int>(found > 0), down += static_cast<int>(found < 0), ++asked;
    return up == 0 || down == 0;
  };
  if (!holds(1, of_a, e, e.left) || !holds(1, of_a, e, e.right) || !holds(-1, of_b, f, f.left) ||
      !holds(-1, of_b, f, f.right))
    return 2;
  return up == asked ? 1 : down == asked ? -1 : 0;
}

class Candidates {
 public:
  Candidates(const Meshd& a, const Meshd& b) : a_(a), b_(b), edges_of_a_(edges_of(a)), edges_of_b_(edges_of(b)) {
    moderate_ = all_moderate(a) && all_moderate(b);
    for (std::size_t i = 0; i < a.faces.size(); ++i) add_face(Candidate::Kind::face_of_a, a, i, b);
    for (std::size_t i = 0; i < b.faces.size(); ++i) add_face(Candidate::Kind::face_of_b, b, i, a);
    for (std::size_t i = 0; i < edges_of_a_.size(); ++i)
      for (std::size_t j = 0; j < edges_of_b_.size(); ++j) add_edges(i, j);
  }

  const Edge& edge_of_a(const Candidate& found) const { return edges_of_a_[found.i]; }
  const Edge& edge_of_b(const Candidate& found) const { return edges_of_b_[found.j]; }

  /// Calls `use` with those whose overlap is not certain to be greater than another's.
  template <class Use>
  void for_each(const Use& use) const {
    for (const Candidate& each : all_)
      if (!(each.least > most_)) use(each);
  }

 private:
  void add(Candidate::Kind kind, std::size_t i, std::size_t j, const DistanceRange& range) {
    all_.push_back({kind, i, j, range.least}), most_ = std::min(most_, range.most);
  }

  /// Along the inward normal of a face the other solid reaches as far as its farthest vertex.
  void add_face(Candidate::Kind kind, const Meshd& mesh, std::size_t i, const Meshd& other) {
    if (!moderate_) return all_.push_back({kind, i, 0, 0});
    const auto at = [&](Index k) { return mesh.vertices[k]; };
    const auto [p, q, r] = mesh.faces[i];
    const auto normal = cross(filters::sized_between(at(p), at(q)), filters::sized_between(at(p), at(r)));
    int inward = 0;
    for (std::size_t k = 0; k < mesh.vertices.size() && inward == 0; ++k)
      inward = side(dot(normal, filters::sized_between(at(p), mesh.vertices[k])));
    if (inward == 0) return all_.push_back({kind, i, 0, 0});
    double low = 0, high = 0;
    for (const Point3d& vertex : other.vertices) {
      const auto height = dot(normal, filters::sized_between(at(p), vertex));
      const double value = inward * height.value, error = height.error();
      low = std::max(low, value - error), high = std::max(high, value + error);
    }
    add(kind, i, 0, DistanceRange(low, high, dot(normal, normal)));
  }

  void add_edges(std::size_t i, std::size_t j) {
    if (!moderate_) return all_.push_back({Candidate::Kind::edges, i, j, 0});
    const auto between = [](const Meshd& mesh) {
      return [&mesh](Index from, Index to) { return filters::sized_between(mesh.vertices[from], mesh.vertices[to]); };
    };
    const auto of_a = between(a_), of_b = between(b_);
    const Edge &e = edges_of_a_[i], &f = edges_of_b_[j];
    const auto normal = cross(of_a(e.from, e.to), of_b(f.from, f.to));
    const int turn = turn_of(normal, e, f, of_a, of_b);
    if (turn == 2) return;
    if (turn == 0) return all_.push_back({Candidate::Kind::edges, i, j, 0});
    const auto height = dot(normal, filters::sized_between(a_.vertices[e.from], b_.vertices[f.from]));
    const double value = turn * height.value, error = height.error();
    add(Candidate::Kind::edges, i, j, DistanceRange(value - error, value + error, dot(normal, normal)));
  }

  const Meshd &a_, &b_;
  std::vector<Edge> edges_of_a_, edges_of_b_;
  std::vector<Candidate> all_;
  double most_ = std::numeric_limits<double>::infinity();
  bool moderate_ = false;
};

struct Found {
  IntegerVector direction;
  mpz_class height, square;
  Index of_a, of_b;  // a vertex of each that is farthest
};

/// The least of the overlaps along some directions.
class Least {
 public:
  Least(const Meshd& a, const Meshd& b) : a_(a), b_(b) {}

  void add(Found next) {
    if (best_) {
      const mpz_class here = next.height * next.height * best_->square,
                      there = best_->height * best_->height * next.square;
      if (here > there || (here == there && !(farthest(next) < farthest(*best_)))) return;
    }
    best_ = std::move(next);
  }
  /// False, and nothing is added, if one of the vertices is not farthest.
  bool add_if_farthest(Found next) {
    const auto [of_a, of_b] = farthest(next);
    const bool known = std::binary_search(of_a.begin(), of_a.end(), next.of_a) &&
                       std::binary_search(of_b.begin(), of_b.end(), next.of_b);
    if (known) add(std::move(next));
    return known;
  }

  CoreOverlap found(int exponent) const {
    const auto [of_a, of_b] = farthest(best_.value());
    return {best_->direction, best_->height, mpz_class(1), exponent, of_a, of_b};
  }

 private:
  using Levels = std::pair<std::vector<Index>, std::vector<Index>>;

  Levels farthest(const Found& found) const {
    Levels levels{lowest_vertices(a_.vertices, {found.of_a}, found.direction),
                  lowest_vertices(b_.vertices, {found.of_b}, mpz_class(-1) * found.direction)};
    std::sort(levels.first.begin(), levels.first.end()), std::sort(levels.second.begin(), levels.second.end());
    return levels;
  }

  const Meshd &a_, &b_;
  std::optional<Found> best_;
};

/// Overlaps along the directions of faces and pairs of edges, each on integers.
class Overlaps {
 public:
  Overlaps(const Meshd& a, const Meshd& b) : a_(a), b_(b), least_(a, b) {
    Polygon3d all{a.vertices};
    all.vertices.insert(all.vertices.end(), b.vertices.begin(), b.vertices.end());
    auto points = integers_of(all);
    exponent_ = points.exponent, at_ = std::move(points.at);
  }

  void add_face_of_a(const Face& f) {
    const auto normal = inward_normal(f, 0, a_.vertices.size());
    const auto [height, farthest] = reach(normal, at_[f.a], a_.vertices.size(), at_.size());
    add(normal, height, f.a, static_cast<Index>(farthest - a_.vertices.size()));
  }
  void add_face_of_b(const Face& f) {
    const std::size_t first = a_.vertices.size();
    const auto inward = inward_normal(f, first, at_.size());
    const auto [height, farthest] = reach(inward, at_[first + f.a], 0, first);
    add(mpz_class(-1) * inward, height, static_cast<Index>(farthest), f.a);
  }
  void add_edges(const Edge& e, const Edge& f) {
    const std::size_t first = a_.vertices.size();
    const auto between = [this](std::size_t start) {
      return [this, start](Index from, Index to) { return IntegerVector(at_[start + to] - at_[start + from]); };
    };
    const auto of_a = between(0), of_b = between(first);
    const IntegerVector normal = cross(of_a(e.from, e.to), of_b(f.from, f.to));
    const int turn = turn_of(normal, e, f, of_a, of_b);
    if (turn == 2 || turn == 0) return;
    const IntegerVector direction = mpz_class(turn) * normal;
    add(direction, dot(direction, at_[first + f.from] - at_[e.from]), e.from, f.from);
  }

  CoreOverlap found() const { return least_.found(exponent_); }

 private:
  /// That of a face, on whose plane's one side all vertices from `first` to `last` lie, or in it: then of a triangle.
  IntegerVector inward_normal(const Face& f, std::size_t first, std::size_t last) const {
    const IntegerPoint& p = at_[first + f.a];
    const IntegerVector normal = cross(at_[first + f.b] - p, at_[first + f.c] - p);
    int inward = 0;
    for (std::size_t k = first; k < last && inward == 0; ++k) inward = sgn(dot(normal, at_[k] - p));
    return mpz_class(inward == 0 ? -1 : inward) * normal;
  }
  std::pair<mpz_class, std::size_t> reach(const IntegerVector& direction, const IntegerPoint& from, std::size_t first,
                                          std::size_t last) const {
    std::pair<mpz_class, std::size_t> most{dot(direction, at_[first] - from), first};
    for (std::size_t k = first + 1; k < last; ++k) {
      mpz_class height = dot(direction, at_[k] - from);
      if (height > most.first) most = {std::move(height), k};
    }
    return most;
  }
  void add(const IntegerVector& direction, const mpz_class& height, Index of_a, Index of_b) {
    least_.add({direction, height, dot(direction, direction), of_a, of_b});
  }

  const Meshd &a_, &b_;
  std::vector<IntegerPoint> at_;
  int exponent_ = 0;
  Least least_;
};

}  // namespace

std::optional<CoreOverlap> least_of_faces(const Meshd& a, const Meshd& b, const std::vector<DifferenceFace>& faces) {
  Polygon3d used;
  for (const DifferenceFace& face : faces)
    for (const auto& [i, j] : face) used.vertices.push_back(a.vertices[i]), used.vertices.push_back(b.vertices[j]);
  const auto points = integers_of(used);
  Least least(a, b);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const auto corner = [&at = points.at, k](std::size_t m) { return at[6 * k + 2 * m + 1] - at[6 * k + 2 * m]; };
    const IntegerVector p = corner(0), normal = cross(corner(1) - p, corner(2) - p);
    const auto [of_a, of_b] = faces[k][0];
    if (!least.add_if_farthest({normal, dot(normal, p), dot(normal, normal), of_a, of_b})) return std::nullopt;
  }
  return least.found(points.exponent);
}

namespace {

CoreOverlap least_of_all(const Meshd& a, const Meshd& b) {
  const Candidates candidates(a, b);
  Overlaps overlaps(a, b);
  candidates.for_each([&](const Candidate& each) {
    if (each.kind == Candidate::Kind::face_of_a) overlaps.add_face_of_a(a.faces[each.i]);
    else if (each.kind == Candidate::Kind::face_of_b) overlaps.add_face_of_b(b.faces[each.i]);
    else overlaps.add_edges(candidates.edge_of_a(each), candidates.edge_of_b(each));
  });
  return overlaps.found();
}

std::vector<Index> all_of(const Meshd& mesh) {
  std::vector<Index> indices(mesh.vertices.size());
  std::iota(indices.begin(), indices.end(), Index{0});
  return indices;
}

}  // namespace

CoreOverlap least_overlap(const Meshd& a, const Meshd& b) {
  if (is_simplex(a) && is_simplex(b)) {
    const auto spans = spans_of({&a, &b});
    if (spans.size() < 3) return {last_across(spans), mpz_class(0), mpz_class(1), 0, all_of(a), all_of(b)};
  }
  return least_of_all(with_sides(a), with_sides(b));
}

}  // namespace touchstone::robust::kernel
