// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/point_in_polyhedron.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include "oracle/exact/closed_mesh.h"
#include "oracle/exact/rational_validation.h"
#include "oracle/exact/whole_cloud.h"
#include "oracle/exact/wide.h"

namespace touchstone::oracle {
namespace {

using Whole = Vector3<Integer>;

/// A face as the point sees it, in integers, the point at the origin; and what its edges span with the origin.
struct Seen {
  std::array<Whole, 3> corners, spans;  // spans[k] = corners[k] x corners[k + 1]
  Integer volume() const { return dot(corners[0], spans[1]); }
};

struct Question {
  std::vector<Seen> faces;
  Rational unit;
};

template <class Number>
Question validated(const Mesh<Number>& mesh, const Point3<Number>& point) {
  validation::validate_numbers("mesh", mesh), validation::validate_numbers("point", point);
  validation::validate("mesh", mesh), validation::validate_triangles("mesh", mesh);
  validate_closed("mesh", mesh.faces);
  std::vector<Point3<Number>> points = mesh.vertices;
  points.push_back(point);
  const WholeCloud cloud(points);
  Question question{{}, cloud.unit};
  const Index origin = cloud.size() - 1;
  for (const Face& f : mesh.faces) {
    const Whole a = cloud.between(origin, f.a), b = cloud.between(origin, f.b), c = cloud.between(origin, f.c);
    question.faces.push_back({{a, b, c}, {cross(a, b), cross(b, c), cross(c, a)}});
  }
  return question;
}

using Weights = std::array<Rational, 3>;

/// The weights of the corners of a face with an area that give the foot of the origin in its plane.
Weights weights_of_foot(const Seen& face, const Whole& normal) {
  const Integer square = dot(normal, normal);
  const auto weight = [&](std::size_t k) { return quotient(Integer(dot(face.spans[(k + 1) % 3], normal)), square); };
  return {weight(0), weight(1), weight(2)};
}

Whole normal_of(const Seen& face) {
  return cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]);
}

bool none_negative(const Weights& weights) {
  return std::all_of(weights.begin(), weights.end(), [](const Rational& weight) { return sgn(weight) >= 0; });
}

/// That give the origin itself, if it is in the face.
std::optional<Weights> weights_of_origin(const Seen& face) {
  if (sgn(face.volume()) != 0) return std::nullopt;
  const Whole normal = normal_of(face);
  if (!zero(normal)) {
    Weights weights = weights_of_foot(face, normal);
    return none_negative(weights) ? std::optional(std::move(weights)) : std::nullopt;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Whole &a = face.corners[k], &b = face.corners[(k + 1) % 3], along = b - a;
    if (!zero(face.spans[k]) || sgn(dot(a, b)) > 0) continue;
    Weights weights;
    weights[(k + 1) % 3] = zero(along) ? Rational(0) : quotient(Integer(-dot(a, along)), Integer(dot(along, along)));
    weights[k] = 1 - weights[(k + 1) % 3];
    return weights;
  }
  return std::nullopt;
}

/// On which sides of a face's edges a ray from the origin passes; empty if its line may meet one of them. An edge on a
/// line through the origin, which is not on the edge, is met only in a direction along that line.
std::optional<std::array<Integer, 3>> sides(const Seen& face, const Whole& direction) {
  std::array<Integer, 3> found;
  for (std::size_t k = 0; k < 3; ++k) {
    found[k] = dot(direction, face.spans[k]);
    if (sgn(found[k]) != 0) continue;
    if (!zero(face.spans[k]) || zero(cross(direction, face.corners[k]))) return std::nullopt;
  }
  return found;
}

struct Crossing {
  std::size_t face;
  Rational t;
};
struct Ray {
  Whole direction;
  std::vector<Crossing> crossings;
};

std::optional<Ray> along(const Question& q, Whole direction) {
  Ray ray{std::move(direction), {}};
  for (std::size_t i = 0; i < q.faces.size(); ++i) {
    const auto passed = sides(q.faces[i], ray.direction);
    if (!passed) return std::nullopt;
    const auto& [u, v, w] = *passed;
    if (sgn(u) == 0 || sgn(u) != sgn(v) || sgn(v) != sgn(w)) continue;
    Rational t = quotient(q.faces[i].volume(), Integer(u + v + w));
    if (sgn(t) > 0) ray.crossings.push_back({i, std::move(t)});
  }
  return ray;
}

/// The first k > 0 whose direction does. An edge and the origin span a plane, which a curve of the second degree meets
/// at most twice, or a line: finitely many k do not.
template <class Direction>
Ray missing_all_edges(const Question& q, const Direction& direction) {
  for (long k = 1;; ++k) {
    if (auto ray = along(q, direction(k))) return std::move(*ray);
  }
}

Rational squared_length(const Whole& v) { return Rational(Integer(dot(v, v))); }

Rational squared_distance(const Whole& a, const Whole& b) {
  const Whole along = b - a;
  if (sgn(Integer(dot(a, along))) >= 0) return squared_length(a);
  if (sgn(Integer(dot(b, along))) <= 0) return squared_length(b);
  const Whole span = cross(a, b);
  return quotient(Integer(dot(span, span)), Integer(dot(along, along)));
}

Rational squared_distance(const Seen& face) {
  const Whole normal = normal_of(face);
  if (!zero(normal) && none_negative(weights_of_foot(face, normal))) {
    const Integer height = face.volume();
    return quotient(Integer(height * height), Integer(dot(normal, normal)));
  }
  const auto& [a, b, c] = face.corners;
  return std::min({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
}

Certificate on_face(std::size_t face, const Weights& weights) {
  return {"on_face", {{"face", {Rational(face)}}, {"weights", {weights[0], weights[1], weights[2]}}}};
}

/// The direction counted in no unit, so that t counts the mesh's.
Certificate crossings(const Ray& ray, const Rational& unit) {
  std::vector<Rational> faces, parameters;
  for (const Crossing& crossing : ray.crossings)
    faces.emplace_back(crossing.face), parameters.push_back(crossing.t * unit);
  const auto& [x, y, z] = ray.direction;
  return {"crossings", {{"direction", {Rational(x), Rational(y), Rational(z)}}, {"faces", faces}, {"t", parameters}}};
}

template <class Number>
Truth<Location> truth_of(const Mesh<Number>& mesh, const Point3<Number>& point) {
  const Question q = validated(mesh, point);
  for (std::size_t i = 0; i < q.faces.size(); ++i) {
    if (auto weights = weights_of_origin(q.faces[i]))
      return {Location::boundary, Rational(0), [i, weights = std::move(*weights)] { return on_face(i, weights); }};
  }
  Ray ray = missing_all_edges(q, [](long k) { return Whole{1, k, k * k}; });
  const bool odd = ray.crossings.size() % 2 == 1;
  for (const Ray& other : {missing_all_edges(q,
                                             [](long k) {
                                               return Whole{-k * k, -1, k};
                                             }),
                           missing_all_edges(q, [](long k) {
                             return Whole{k, -k * k, -1};
                           })}) {
    if ((other.crossings.size() % 2 == 1) != odd) throw std::logic_error("point_in_polyhedron: two rays disagree");
  }
  Rational least = squared_distance(q.faces[0]);
  for (const Seen& face : q.faces) least = std::min(least, squared_distance(face));
  return {odd ? Location::inside : Location::outside, Rational(least * q.unit * q.unit),
          [ray = std::move(ray), unit = q.unit] { return crossings(ray, unit); }};
}

}  // namespace

Truth<Location> point_in_polyhedron(const Meshd& mesh, const Point3d& point) { return truth_of(mesh, point); }

template <Exact Number>
Truth<Location> point_in_polyhedron(const Mesh<Number>& mesh, const Point3<Number>& point) {
  return truth_of(mesh, point);
}
template Truth<Location> point_in_polyhedron(const Mesh<Rational>&, const Point3<Rational>&);

}  // namespace touchstone::oracle
