// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/solid_distance.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

using Displacement = Vector3<Integer>;
using Point = Point3<Rational>;
using Vector = Vector3<Rational>;

Point rational_point(const IntegerPoint& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
Vector rational_vector(const Displacement& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }
Vector minus(const Vector& v) { return Rational(-1) * v; }

Rational height_over(const IntegerPlane& plane, const Point& p) {
  return dot(rational_vector(plane.normal), p - Point{0, 0, 0}) + plane.offset;
}

/// The least t in [0, 1] for which a + t (b - a) is in the solid.
std::optional<Rational> first_within(const IntegerSolid& solid, const Point& a, const Point& b) {
  Rational low(0), high(1);
  for (const IntegerPlane& plane : solid.planes) {
    const Rational from = height_over(plane, a), to = height_over(plane, b);
    if (sgn(from) > 0 && sgn(to) > 0) return std::nullopt;
    if (sgn(from) > 0) low = std::max(low, Rational(from / (from - to)));
    else if (sgn(to) > 0) high = std::min(high, Rational(from / (from - to)));
  }
  if (low > high) return std::nullopt;
  return low;
}

/// The shortest of several displacements, each in integers over a denominator.
class Shortest {
 public:
  /// A normal times height / square, square that of the normal.
  bool beats(const Integer& height, const Integer& square) const {
    return !denominator_ || height * height * *denominator_ < square_ * square;
  }
  void set(const Displacement& normal, const Integer& height, const Integer& square) {
    square_ = height * height, denominator_ = square;
    displacement_ = quotient(height, square) * rational_vector(normal);
  }
  void try_displacement(const Displacement& displacement, const Integer& denominator) {
    const Integer square = dot(displacement, displacement), unit = denominator * denominator;
    if (denominator_ && square * *denominator_ >= square_ * unit) return;
    square_ = square, denominator_ = unit;
    displacement_ = quotient(Integer(1), denominator) * rational_vector(displacement);
  }
  const Vector& displacement() const { return displacement_; }

 private:
  std::optional<Integer> denominator_;
  Integer square_;
  Vector displacement_;
};

void try_vertex_and_edge(Shortest& shortest, const IntegerPoint& p, const IntegerPoint& from, const IntegerPoint& to,
                         int sign) {
  const Displacement edge = to - from, displacement = p - from;
  const Integer along = dot(displacement, edge), length = dot(edge, edge);
  if (sgn(along) <= 0 || along >= length) return;
  shortest.try_displacement(Integer(sign * length) * displacement - Integer(sign * along) * edge, length);
}

void try_vertex_and_face(Shortest& shortest, const IntegerPoint& p, const IntegerSolid& solid, std::size_t face,
                         int sign) {
  const auto& [normal, offset] = solid.planes[face];
  const Integer height = solid.planes[face].at(p), square = dot(normal, normal);
  if (sgn(height) <= 0 || !shortest.beats(height, square)) return;
  const auto [a, b, c] = solid.faces[face];
  const Displacement turned = cross(solid.vertices[b] - solid.vertices[a], solid.vertices[c] - solid.vertices[a]);
  for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
    const IntegerPoint &from = solid.vertices[i], &to = solid.vertices[j];
    if (sgn(dot(turned, cross(to - from, p - from))) < 0) return;
  }
  shortest.set(normal, Integer(sign * height), square);
}

void try_edges(Shortest& shortest, const IntegerPoint& a0, const IntegerPoint& a1, const IntegerPoint& b0,
               const IntegerPoint& b1) {
  const Displacement v = a1 - a0, w = b1 - b0, normal = cross(v, w), between = a0 - b0;
  const Integer square = dot(normal, normal), height = dot(between, normal);
  if (sgn(square) == 0 || !shortest.beats(height, square)) return;
  const Integer on_a = -dot(cross(between, w), normal), on_b = -dot(cross(between, v), normal);
  if (sgn(on_a) < 0 || on_a > square || sgn(on_b) < 0 || on_b > square) return;
  shortest.set(normal, height, square);
}

/// All vertices such that no other is lower.
std::vector<Index> lowest(const std::vector<IntegerPoint>& vertices, const Vector& direction) {
  std::vector<Index> found{0};
  for (Index i = 1; i < vertices.size(); ++i) {
    const int side = sgn(dot(direction, rational_vector(vertices[i] - vertices[found[0]])));
    if (side < 0) found.clear();
    if (side <= 0) found.push_back(i);
  }
  return found;
}

/// The vertices and edges of a solid in the plane of all its lowest points, translated.
struct LowestPart {
  std::vector<Point> vertices;
  std::vector<std::pair<Point, Vector>> edges;

  LowestPart(const IntegerSolid& solid, const Vector& direction, const Vector& by) {
    const std::vector<Index> all = lowest(solid.vertices, direction);
    const auto level = [&all](Index i) { return std::find(all.begin(), all.end(), i) != all.end(); };
    for (const Index i : all) vertices.push_back(rational_point(solid.vertices[i]) + by);
    for (const auto& [i, j] : solid.edges)
      if (level(i) && level(j))
        edges.push_back(
            {rational_point(solid.vertices[i]) + by, rational_vector(solid.vertices[j] - solid.vertices[i])});
  }
};

Point foot_on_line(const Point& p, const Point& on, const Vector& along) {
  return on + Rational(dot(p - on, along) / dot(along, along)) * along;
}

std::vector<Point> candidates(const LowestPart& a, const LowestPart& b, const Vector& normal, const Point& start) {
  std::vector<Point> all = a.vertices;
  all.insert(all.end(), b.vertices.begin(), b.vertices.end());
  for (const LowestPart* part : {&a, &b})
    for (const auto& [p, along] : part->edges) all.push_back(foot_on_line(start, p, along));
  for (const auto& [p, v] : a.edges) {
    for (const auto& [q, w] : b.edges) {
      const Vector across = cross(v, w);
      const Rational square = dot(across, across);
      if (sgn(square) != 0) all.push_back(p + Rational(dot(cross(q - p, w), across) / square) * v);
    }
  }
  all.push_back(start + Rational(dot(a.vertices[0] - start, normal) / dot(normal, normal)) * normal);
  return all;
}

Integer denominator_of(const std::vector<Rational>& numbers) {
  Integer common(1);
  for (const Rational& number : numbers) mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), number.get_den_mpz_t());
  return common;
}

/// The multiplier for the lowest vertices of a and the highest of b alone, by a linear program in the positive and the
/// negative part of each coordinate. Displacements are from the nearest points, all times one integer.
Vector multiplier_of_lowest(const std::vector<Vector>& of_a, const std::vector<Vector>& of_b, const Vector& from_first,
                            const Integer& unit) {
  using Program = LinearProgram<Integer>;
  Program program(6, std::vector<Program::Row>(of_a.size() + of_b.size(), Program::Row::at_most));
  int row = 0;
  const auto set = [&](const Vector& displacement, int sign) {
    int column = 0;
    for (const Rational* coordinate : {&displacement.x, &displacement.y, &displacement.z}) {
      const Rational coefficient(*coordinate * unit * sign);
      program.set_coefficient(row, column++, coefficient.get_num());
      program.set_coefficient(row, column++, Integer(-coefficient.get_num()));
    }
  };
  for (const Vector& displacement : of_a) set(displacement, -1), ++row;
  for (const Vector& displacement : of_b) {
    set(displacement, 1);
    program.set_right_side(row++, Rational(dot(from_first, displacement) * unit * unit).get_num());
  }
  if (!program.feasible()) throw std::logic_error("the first nearest point has a multiplier");
  const auto part = [&](int k) {
    Rational number(Integer(program.numerator(2 * k) - program.numerator(2 * k + 1)),
                    Integer(program.denominator() * unit));
    number.canonicalize();
    return number;
  };
  return {part(0), part(1), part(2)};
}

}  // namespace

IntegerSolid::IntegerSolid(const ConvexMesh& mesh, const std::vector<std::array<Integer, 3>>& at) : faces(mesh.faces) {
  for (const auto& [x, y, z] : at) vertices.push_back({x, y, z});
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const IntegerPoint& corner = vertices[faces[i].a];
    const Displacement& normal = mesh.planes[i].normal;
    planes.push_back({normal, Integer(-dot(normal, Displacement{corner.x, corner.y, corner.z}))});
    const auto [a, b, c] = faces[i];
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
      if (from < to) edges.push_back({from, to});
  }
}

Hull IntegerSolid::hull() const {
  Hull points;
  for (const IntegerPoint& p : vertices) points.push_back(rational_point(p));
  return points;
}

bool IntegerSolid::holds(const Point& p) const {
  return std::all_of(planes.begin(), planes.end(),
                     [&p](const IntegerPlane& plane) { return sgn(height_over(plane, p)) <= 0; });
}

std::vector<Rational> IntegerSolid::weights(const Point& p) const {
  for (const Face& face : faces) {
    const Point a = rational_point(vertices[face.a]), b = rational_point(vertices[face.b]),
                c = rational_point(vertices[face.c]);
    const Vector normal = cross(b - a, c - a);
    if (sgn(dot(normal, p - a)) != 0) continue;
    const Rational whole = dot(normal, normal), of_a = dot(normal, cross(c - b, p - b)) / whole,
                   of_b = dot(normal, cross(a - c, p - c)) / whole, of_c = 1 - of_a - of_b;
    if (sgn(of_a) < 0 || sgn(of_b) < 0 || sgn(of_c) < 0) continue;
    std::vector<Rational> found(vertices.size());
    found[face.a] = of_a, found[face.b] = of_b, found[face.c] = of_c;
    return found;
  }
  throw std::logic_error("a point of the surface is on a face");
}

IntegerSolid::IntegerSolid(std::vector<IntegerPoint> ends) : vertices(std::move(ends)) {
  if (vertices.size() == 2) edges.push_back({0, 1});
}

/// The way from a vertex through an inner point leaves the solid at one of the surface, that many times as far away.
std::vector<Rational> IntegerSolid::weights_within(const Point& p) const {
  const Index vertex = faces[0].a;
  const Point from = rational_point(vertices[vertex]);
  std::optional<Rational> times;
  for (const IntegerPlane& plane : planes) {
    const Rational here = height_over(plane, from), there = height_over(plane, p);
    if (sgn(there) == 0) return weights(p);
    if (there > here) times = std::min(Rational(here / (here - there)), times.value_or(here / (here - there)));
  }
  std::vector<Rational> found = weights(from + times.value() * (p - from));
  for (Rational& weight : found) weight /= *times;
  found[vertex] += 1 - 1 / *times;
  return found;
}

NearestPair nearest_pair(const Hull& ends, const ConvexMesh& mesh) {
  Integer whole(1);
  std::vector<HomogeneousPoint> found;
  for (const Point& p : ends) {
    found.push_back(mesh.integer(p));
    mpz_lcm(whole.get_mpz_t(), whole.get_mpz_t(), found.back().w.get_mpz_t());
  }
  std::vector<IntegerPoint> core;
  for (const auto& [x, y, z, w] : found)
    core.push_back({Integer(x * (whole / w)), Integer(y * (whole / w)), Integer(z * (whole / w))});
  std::vector<std::array<Integer, 3>> at;
  for (const auto& [x, y, z] : mesh.vertices)
    at.push_back({Integer(whole * x), Integer(whole * y), Integer(whole * z)});
  const IntegerSolid segment(core), solid(mesh, at);
  const Point a = rational_point(core.front()), b = rational_point(core.back());
  Vector displacement{0, 0, 0};
  std::optional<Rational> t = first_within(solid, a, b);
  if (!t) {
    displacement = shortest_displacement(segment, solid);
    t = first_within(solid, a + minus(displacement), b + minus(displacement));
  }
  const Point on_a = a + t.value() * (b - a), on_b = on_a + minus(displacement);
  const Rational unit(mesh.unit / whole);
  const auto in_units = [&unit](const Point& p) {
    return Point{Rational(p.x * unit), Rational(p.y * unit), Rational(p.z * unit)};
  };
  std::vector<Rational> of_a{Rational(1 - *t)};
  if (ends.size() == 2) of_a.push_back(*t);
  return {in_units(on_a), in_units(on_b), std::move(of_a), solid.weights_within(on_b),
          Rational(dot(displacement, displacement) * unit * unit)};
}

Vector shortest_displacement(const IntegerSolid& a, const IntegerSolid& b) {
  Shortest shortest;
  for (const IntegerPoint& p : a.vertices)
    for (const IntegerPoint& q : b.vertices) shortest.try_displacement(p - q, 1);
  const auto vertices_of_first = [&shortest](const IntegerSolid& first, const IntegerSolid& second, int sign) {
    for (const IntegerPoint& p : first.vertices) {
      for (const auto& [i, j] : second.edges)
        try_vertex_and_edge(shortest, p, second.vertices[i], second.vertices[j], sign);
      for (std::size_t face = 0; face < second.faces.size(); ++face)
        try_vertex_and_face(shortest, p, second, face, sign);
    }
  };
  vertices_of_first(a, b, 1), vertices_of_first(b, a, -1);
  for (const auto& [i, j] : a.edges)
    for (const auto& [k, l] : b.edges) try_edges(shortest, a.vertices[i], a.vertices[j], b.vertices[k], b.vertices[l]);
  return shortest.displacement();
}

Point nearest_to(const Point& start, const IntegerSolid& a, const IntegerSolid& b, const Vector& displacement) {
  const LowestPart lowest(a, displacement, {0, 0, 0}), highest(b, minus(displacement), displacement);
  std::optional<Point> nearest;
  Rational least;
  for (const Point& p : candidates(lowest, highest, displacement, start)) {
    const Rational square = dot(p - start, p - start);
    if ((nearest && square >= least) || !a.holds(p) || !b.holds(p + minus(displacement))) continue;
    nearest = p, least = square;
  }
  return nearest.value();
}

Point first_nearest(const IntegerSolid& a, const IntegerSolid& b, const Vector& displacement) {
  return nearest_to(rational_point(a.vertices[0]), a, b, displacement);
}

/// The multiplier for the lowest vertices, plus enough of the displacement to satisfy the conditions of all others.
std::vector<Rational> multiplier(const Hull& a, const Hull& b, const Point& on_a, const Vector& displacement) {
  const Point on_b = on_a + minus(displacement);
  const Vector from_first = on_a - a[0];
  std::vector<Rational> numbers;
  const auto displacements_to = [&numbers](const Hull& hull, const Point& from) {
    std::vector<Vector> displacements;
    for (const Point& p : hull) {
      displacements.push_back(p - from);
      const auto& [x, y, z] = displacements.back();
      numbers.insert(numbers.end(), {x, y, z});
    }
    return displacements;
  };
  const auto level = [&displacement](std::vector<Vector> displacements) {
    const auto off = [&displacement](const Vector& to) { return sgn(dot(displacement, to)) != 0; };
    displacements.erase(std::remove_if(displacements.begin(), displacements.end(), off), displacements.end());
    return displacements;
  };
  const std::vector<Vector> to_a = displacements_to(a, on_a), to_b = displacements_to(b, on_b);
  const Vector g = multiplier_of_lowest(level(to_a), level(to_b), from_first, denominator_of(numbers)),
               h = from_first - g;
  Rational steps;
  const auto hold_off = [&](const std::vector<Vector>& displacements, const Vector& part) {
    for (const Vector& to : displacements) {
      const Rational height = abs(dot(displacement, to));
      if (sgn(height) != 0) steps = std::max(steps, Rational(-dot(part, to) / height));
    }
  };
  hold_off(to_a, g), hold_off(to_b, h);
  const Vector found = g + steps * displacement;
  return {found.x, found.y, found.z};
}

}  // namespace touchstone::oracle
