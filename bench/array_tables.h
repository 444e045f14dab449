// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "bench/data_sets.h"
#include "catalogue/catalogue.h"

/// The rows of the arrays that are timed.
namespace touchstone::bench {

using catalogue::Operation;
using catalogue::Question;
using catalogue::Word;
using robust::batch::Column;

enum class Cases { random, one_in_a_hundred, near_degenerate, hard };
inline const char* name_of(Cases kind) {
  constexpr const char* names[] = {"random", "one_in_a_hundred_near", "near_degenerate", "every_hard_case"};
  return names[static_cast<std::size_t>(kind)];
}

inline Word decision(const Operation& operation, const Question& question) {
  const auto& row = operation.row();
  return row.decide != nullptr ? row.decide(question, 0) : row.robust(question, 0).words.at(0);
}

inline bool accepted(const Operation& operation, const Question& question) {
  try {
    decision(operation, question);
  } catch (const InvalidInput&) {
    return false;
  }
  return true;
}

/// All hard cases, or those of full precision; also all if none is named as one of full precision.
inline std::vector<std::size_t> hard_families(const Operation& operation, Cases kind) {
  std::vector<std::size_t> named, all;
  for (std::size_t i = 0; i < operation.families().size(); ++i) {
    const std::string& name = operation.families()[i];
    if (name.find('+') != std::string::npos) continue;
    if (i < operation.row().hard_cases.size()) all.push_back(i);
    if (near_degenerate(name)) named.push_back(i);
  }
  return named.empty() || kind == Cases::hard ? all : named;
}

/// A table of case_count rows, all like `shape`: of one alternative and, if there are lists, of one list.
struct Table {
  Question shared;
  std::vector<std::vector<double>> numbers;
  std::vector<const double*> starts;
  std::vector<Column> columns;
  std::vector<std::size_t> places;

  Question row(std::size_t i) const {
    Question question = shared;
    for (std::size_t k = 0; k < places.size(); ++k) question.numbers[places[k]] = numbers[k][i];
    return question;
  }
};

/// A shape that all rows share, for operations that ask about many points and one shape.
struct SharedShape {
  Question question;            ///< holds the shape, and any point
  std::vector<double> numbers;  ///< for the naive formula (bench/isa/naive_space.h): `count` parts
  std::size_t count = 0;
  std::function<std::vector<double>(catalogue::DrawStream&)> on_boundary;  ///< draws a point on it, rounded
};

/// A fraction in [0, 1].
inline double fraction(catalogue::DrawStream& draws) { return catalogue::ordinary(draws) / 2 + 0.5; }

/// A ring of 16 vertices: on a circle, or anywhere.
inline SharedShape ring_of(bool convex) {
  Polygon2d ring;
  catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, "ring", 0));
  for (int i = 0; i < 16; ++i) {
    const double x = catalogue::ordinary(draws), y = catalogue::ordinary(draws);
    const double angle = std::numbers::pi * (i + 0.25) / 8;
    if (convex) ring.vertices.push_back({0.9 * std::cos(angle), 0.9 * std::sin(angle)});
    else ring.vertices.push_back({x, y});
  }
  SharedShape shape{Question{catalogue::packed(std::tuple(ring, Point2d{}))}, {}, ring.size(), {}};
  for (const Point2d& p : ring.vertices) shape.numbers.push_back(p.x), shape.numbers.push_back(p.y);
  shape.on_boundary = [ring](catalogue::DrawStream& stream) {
    const std::size_t i = stream.below(ring.size());
    const Point2d p = ring[i] + fraction(stream) * (ring.next(i) - ring[i]);
    return std::vector<double>{p.x, p.y};
  };
  return shape;
}

/// The hull of an octahedron's corners and edge midpoints, all on a sphere: 32 faces.
inline Meshd solid_of_32_faces() {
  Meshd mesh;
  const double r = 0.9;
  mesh.vertices = {{r, 0, 0}, {0, r, 0}, {0, 0, r}, {-r, 0, 0}, {0, -r, 0}, {0, 0, -r}};
  const auto middle = [&](Index i, Index j) {
    const Vector3d sum = (mesh.vertices[i] - Point3d{}) + (mesh.vertices[j] - Point3d{});
    const double size = r / std::sqrt(dot(sum, sum));
    const Point3d p{size * sum.x, size * sum.y, size * sum.z};
    const auto same_place = [&](const Point3d& q) { return q.x == p.x && q.y == p.y && q.z == p.z; };
    const auto found = std::find_if(mesh.vertices.begin(), mesh.vertices.end(), same_place);
    const auto at = static_cast<Index>(found - mesh.vertices.begin());
    if (found == mesh.vertices.end()) mesh.vertices.push_back(p);
    return at;
  };
  for (Index x = 0; x < 6; x += 3) {
    for (Index y = 1; y < 6; y += 3) {
      for (Index z = 2; z < 6; z += 3) {
        const bool mirrored = ((x == 3) != (y == 4)) != (z == 5);
        const Index a = x, b = mirrored ? z : y, c = mirrored ? y : z;
        const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const Face& face : {Face{a, ab, ca}, Face{ab, b, bc}, Face{ca, bc, c}, Face{ab, bc, ca}})
          mesh.faces.push_back(face);
      }
    }
  }
  return mesh;
}

inline SharedShape solid() {
  const Meshd mesh = solid_of_32_faces();
  SharedShape shape{Question{catalogue::packed(std::tuple(mesh, Point3d{}))}, {}, mesh.faces.size(), {}};
  for (const Face& face : mesh.faces) {
    const Point3d& a = mesh.vertices[face.a];
    const Point3d &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
    const Vector3d normal = cross(b - a, c - a);
    for (const double number : {a.x, a.y, a.z, normal.x, normal.y, normal.z, b.x, b.y, b.z, c.x, c.y, c.z})
      shape.numbers.push_back(number);
  }
  shape.on_boundary = [mesh](catalogue::DrawStream& stream) {
    const Face& face = mesh.faces[stream.below(mesh.faces.size())];
    const Point3d& a = mesh.vertices[face.a];
    double s = fraction(stream), t = fraction(stream);
    if (s + t > 1) s = 1 - s, t = 1 - t;
    const Point3d p = a + s * (mesh.vertices[face.b] - a) + t * (mesh.vertices[face.c] - a);
    return std::vector<double>{p.x, p.y, p.z};
  };
  return shape;
}

/// The shape that an operation's points are asked about, found by the operation's name. nullptr if it has none.
inline const SharedShape* shape_of(const Operation& operation) {
  static const SharedShape any_ring = ring_of(false), convex_ring = ring_of(true), convex_solid = solid();
  if (operation.name() == "point_in_polygon") return &any_ring;
  if (operation.name() == "point_in_convex_polygon") return &convex_ring;
  if (operation.name() == "point_in_convex_polyhedron" || operation.name() == "point_in_polyhedron")
    return &convex_solid;
  return nullptr;
}

/// Leaves out `hard` if it would repeat the rows of near_degenerate.
inline std::vector<Cases> kinds_of(const Operation& operation) {
  std::vector<Cases> kinds = {Cases::random, Cases::one_in_a_hundred, Cases::near_degenerate};
  const bool more = hard_families(operation, Cases::hard) != hard_families(operation, Cases::near_degenerate);
  if (more && shape_of(operation) == nullptr) kinds.push_back(Cases::hard);
  return kinds;
}

/// A question of the family, or of points in [-1, 1) and the shape.
inline Question drawn_row(const Operation& operation, std::size_t family, bool hard, catalogue::DrawStream& draws) {
  const SharedShape* const shape = shape_of(operation);
  if (shape == nullptr) return operation.draw(draws, family);
  Question question = shape->question;
  const std::vector<std::size_t> places = operation.row().batch.columns(question);
  const std::vector<double> near = hard ? shape->on_boundary(draws) : std::vector<double>();
  for (std::size_t k = 0; k < places.size(); ++k)
    question.numbers[places[k]] = hard ? near[k] : catalogue::ordinary(draws);
  return question;
}

inline Table drawn_table(const Operation& operation, const std::vector<Word>& words, Cases kind) {
  Table table;
  const auto& families = operation.families();
  const auto random =
      static_cast<std::size_t>(std::find(families.begin(), families.end(), "random") - families.begin());
  const std::vector<std::size_t> near = hard_families(operation, kind);
  std::size_t rows = 0;
  for (std::uint64_t index = 0; rows < case_count; ++index) {
    catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, name_of(kind), index));
    const bool hard = kind == Cases::one_in_a_hundred ? rows % 100 == 0 : kind != Cases::random;
    const std::size_t family = hard ? near[draws.below(near.size())] : random;
    const Question question = drawn_row(operation, family, hard, draws);
    if (question.words != words) continue;
    const bool judged_before = rows > 0 && shape_of(operation) != nullptr;  // the shape; its points are finite
    if (!judged_before && !accepted(operation, question)) continue;
    if (rows == 0) {
      table.shared = question;
      table.places = operation.row().batch.columns(question);
      table.numbers.resize(table.places.size());
      for (auto& column : table.numbers) column.reserve(case_count);
    }
    for (std::size_t k = 0; k < table.places.size(); ++k) table.numbers[k].push_back(question.numbers[table.places[k]]);
    ++rows;
  }
  for (const auto& column : table.numbers) {
    table.starts.push_back(column.data());
    table.columns.emplace_back(column.data(), 1);
  }
  return table;
}

/// The most recent table.
inline const Table& table_of(const Operation& operation, const std::vector<Word>& words, Cases kind) {
  static std::string made;
  static Table table;
  std::string wanted = operation.name() + name_of(kind);
  for (const Word word : words) wanted += std::to_string(word) + " ";
  if (made != wanted) table = drawn_table(operation, words, kind), made = wanted;
  return table;
}

}  // namespace touchstone::bench
