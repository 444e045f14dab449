// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/solid.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/closed_mesh.h"

namespace touchstone::oracle {
namespace {

using IntegerTriple = Vector3<Integer>;
using Weights = std::array<Rational, 3>;
using Corners = std::array<const IntegerTriple*, 3>;

IntegerTriple normal_of(const Corners& c) { return cross(*c[1] - *c[0], *c[2] - *c[0]); }

/// The weights of the corners of a face with an area that give the foot of the origin in its plane, times the square of
/// the normal.
std::array<Integer, 3> weights_of_foot(const Corners& c, const IntegerTriple& normal) {
  const auto weight = [&](std::size_t k) { return dot(cross(*c[(k + 1) % 3], *c[(k + 2) % 3]), normal); };
  return {weight(0), weight(1), weight(2)};
}

bool none_negative(const std::array<Integer, 3>& weights) {
  return std::all_of(weights.begin(), weights.end(), [](const Integer& weight) { return sgn(weight) >= 0; });
}

/// The distance of the origin from the box around the corners, along each axis.
std::array<Integer, 3> displacements_to_box(const Corners& c) {
  std::array<Integer, 3> found;
  std::size_t i = 0;
  for (Integer IntegerTriple::*axis : {&IntegerTriple::x, &IntegerTriple::y, &IntegerTriple::z}) {
    const auto& [low, high] = std::minmax({c[0]->*axis, c[1]->*axis, c[2]->*axis});
    if (sgn(low) > 0) found[i] = low;
    if (sgn(high) < 0) found[i] = -high;
    ++i;
  }
  return found;
}

bool box_holds_origin(const Corners& c) {
  for (Integer IntegerTriple::*axis : {&IntegerTriple::x, &IntegerTriple::y, &IntegerTriple::z}) {
    const int side = sgn(c[0]->*axis);
    if (side != 0 && side == sgn(c[1]->*axis) && side == sgn(c[2]->*axis)) return false;
  }
  return true;
}

/// The weights that give the origin itself, if it is in the face.
std::optional<Weights> weights_of_origin(const Corners& c) {
  if (!box_holds_origin(c) || sgn(dot(*c[0], cross(*c[1], *c[2]))) != 0) return std::nullopt;
  const IntegerTriple normal = normal_of(c);
  if (!zero(normal)) {
    const auto weights = weights_of_foot(c, normal);
    if (!none_negative(weights)) return std::nullopt;
    const Integer square = dot(normal, normal);
    return Weights{quotient(weights[0], square), quotient(weights[1], square), quotient(weights[2], square)};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const IntegerTriple &a = *c[k], &b = *c[(k + 1) % 3], along = b - a;
    if (!zero(cross(a, b)) || sgn(dot(a, b)) > 0) continue;
    Weights weights;
    weights[(k + 1) % 3] = zero(along) ? Rational(0) : quotient(Integer(-dot(a, along)), Integer(dot(along, along)));
    weights[k] = 1 - weights[(k + 1) % 3];
    return weights;
  }
  return std::nullopt;
}

Rational squared_length(const IntegerTriple& v) { return Rational(Integer(dot(v, v))); }

Rational from_segment(const IntegerTriple& a, const IntegerTriple& b) {
  const IntegerTriple along = b - a;
  if (sgn(Integer(dot(a, along))) >= 0) return squared_length(a);
  if (sgn(Integer(dot(b, along))) <= 0) return squared_length(b);
  const IntegerTriple span = cross(a, b);
  return quotient(Integer(dot(span, span)), Integer(dot(along, along)));
}

Rational from_face(const Corners& c) {
  const IntegerTriple normal = normal_of(c);
  if (!zero(normal) && none_negative(weights_of_foot(c, normal))) {
    const Integer height = dot(*c[0], normal);
    return quotient(Integer(height * height), Integer(dot(normal, normal)));
  }
  return std::min({from_segment(*c[0], *c[1]), from_segment(*c[1], *c[2]), from_segment(*c[2], *c[0])});
}

Certificate on_face(std::size_t face, const Weights& weights) {
  return {"on_face", {{"face", {Rational(face)}}, {"weights", {weights[0], weights[1], weights[2]}}}};
}

}  // namespace

/// Vertices relative to the point, times `factor`.
struct Solid::Seen {
  Seen(const Solid& solid, const Point3<Rational>& p) {
    mpz_lcm(factor.get_mpz_t(), p.x.get_den_mpz_t(), p.y.get_den_mpz_t());
    mpz_lcm(factor.get_mpz_t(), factor.get_mpz_t(), p.z.get_den_mpz_t());
    const auto integer = [this](const Rational& n) { return Integer(n.get_num() * (factor / n.get_den())); };
    const Integer x = integer(p.x), y = integer(p.y), z = integer(p.z);
    for (const Point3<Integer>& v : solid.vertices_)
      vertices.push_back({Integer(factor * v.x - x), Integer(factor * v.y - y), Integer(factor * v.z - z)});
  }
  Corners corners(const Face& f) const { return {&vertices[f.a], &vertices[f.b], &vertices[f.c]}; }
  /// The planes spanned by the edges with the origin.
  void span(const Solid& solid) {
    for (const auto& [from, to] : solid.edges_) spans.push_back(cross(vertices[from], vertices[to]));
  }

  Integer factor;
  std::vector<IntegerTriple> vertices, spans;
};

struct Solid::Ray {
  struct Crossing {
    std::size_t face;
    Rational t;
  };
  IntegerTriple direction;
  std::vector<Crossing> crossings;

  bool odd() const { return crossings.size() % 2 == 1; }
  /// The direction is dimensionless, so that t has the mesh's unit.
  Certificate certificate(const Rational& unit) const {
    std::vector<Rational> faces, parameters;
    for (const Crossing& crossing : crossings)
      faces.emplace_back(crossing.face), parameters.push_back(crossing.t * unit);
    const auto& [x, y, z] = direction;
    return {"crossings", {{"direction", {Rational(x), Rational(y), Rational(z)}}, {"faces", faces}, {"t", parameters}}};
  }
};

Solid::Solid(std::vector<Point3<Integer>> vertices, std::vector<Face> faces, Rational unit)
    : vertices_(std::move(vertices)), faces_(std::move(faces)), unit_(std::move(unit)) {
  std::map<std::pair<Index, Index>, std::size_t> known;
  for (const Face& f : faces_) {
    std::array<std::size_t, 3>& list = of_face_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [from, to] = edges_of(f)[k];
      const auto [place, added] = known.emplace(std::minmax(from, to), edges_.size());
      if (added) edges_.push_back({std::min(from, to), std::max(from, to)});
      list[k] = place->second;
    }
  }
}

/// Returns false if the ray's line may meet an edge. An edge on a line through the origin, which is not on the edge, is
/// met only in a direction along that line.
bool Solid::along(Ray& ray, const Seen& seen) const {
  std::vector<Integer> sides;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    sides.push_back(dot(ray.direction, seen.spans[i]));
    if (sgn(sides[i]) != 0) continue;
    if (!zero(seen.spans[i]) || zero(cross(ray.direction, seen.vertices[edges_[i][0]]))) return false;
  }
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const auto edges = edges_of(faces_[i]);
    const auto& [ab, bc, ca] = of_face_[i];
    const auto turn = [&edges](std::size_t k) { return edges[k].first < edges[k].second ? 1 : -1; };
    const int u = turn(0) * sgn(sides[ab]), v = turn(1) * sgn(sides[bc]), w = turn(2) * sgn(sides[ca]);
    if (u == 0 || u != v || v != w) continue;
    const auto [a, b, c] = seen.corners(faces_[i]);
    const Integer volume = dot(*a, cross(*b, *c));
    if (sgn(volume) == u)
      ray.crossings.push_back(
          {i,
           quotient(volume, Integer((turn(0) * sides[ab] + turn(1) * sides[bc] + turn(2) * sides[ca]) * seen.factor))});
  }
  return true;
}

/// The first k > 0 whose direction meets none. An edge and the origin span a plane, which a curve of the second degree
/// meets at most twice, or a line: all but finitely many k work.
template <class Direction>
Solid::Ray Solid::missing_all_edges(const Seen& seen, const Direction& direction) const {
  for (std::int64_t k = 1;; ++k) {
    Ray ray{direction(k), {}};
    if (along(ray, seen)) return ray;
  }
}

Truth<Location> Solid::located(const Point3<Rational>& p, bool by_three_rays) const {
  Seen seen(*this, p);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (auto weights = weights_of_origin(seen.corners(faces_[i])))
      return {Location::boundary, Rational(0), [i, weights = std::move(*weights)] { return on_face(i, weights); }};
  }
  seen.span(*this);
  Ray ray = missing_all_edges(seen, [](std::int64_t k) { return IntegerTriple{1, k, k * k}; });
  if (by_three_rays) {
    const Ray second = missing_all_edges(seen,
                                         [](std::int64_t k) {
                                           return IntegerTriple{-k * k, -1, k};
                                         }),
              third = missing_all_edges(seen, [](std::int64_t k) {
                return IntegerTriple{k, -k * k, -1};
              });
    if (second.odd() != ray.odd() || third.odd() != ray.odd())
      throw std::logic_error("point_in_polyhedron: two rays disagree");
  }
  const Location location = ray.odd() ? Location::inside : Location::outside;
  return {location, std::nullopt, [ray = std::move(ray), unit = unit_] { return ray.certificate(unit); }};
}

Truth<Location> Solid::locate(const Point3<Rational>& p) const { return located(p, false); }
Truth<Location> Solid::locate_by_three_rays(const Point3<Rational>& p) const { return located(p, true); }

Rational Solid::squared_distance(const Point3<Rational>& p) const {
  const Seen seen(*this, p);
  std::optional<Rational> least;
  for (const Face& f : faces_) {
    const Corners corners = seen.corners(f);
    if (least) {
      const auto [x, y, z] = displacements_to_box(corners);
      if (*least <= Rational(Integer(x * x + y * y + z * z))) continue;
    }
    Rational found = from_face(corners);
    if (!least || found < *least) least = std::move(found);
  }
  return quotient(least->get_num(), Integer(least->get_den() * seen.factor * seen.factor));
}

}  // namespace touchstone::oracle
