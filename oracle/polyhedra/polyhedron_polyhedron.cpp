// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/polyhedron_polyhedron.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/closed_mesh.h"
#include "oracle/exact/solids/common_dimension.h"
#include "oracle/exact/solids/plane_between.h"
#include "oracle/exact/solids/polygon_faces.h"
#include "oracle/exact/solids/solid.h"
#include "oracle/exact/solids/space_partition.h"

namespace touchstone::oracle {
namespace {

using Triangle = Triangle3<Integer>;
using Point = Point3<Rational>;
using Cells = SpacePartition::Cells;
using PolyhedronPolyhedronAnswer = Truth<PolyhedronPolyhedron>;

template <class Number>
void validate_solid(const std::string& field, const Mesh<Number>& mesh) {
  validation::validate(field, mesh), validate_polygons(field, mesh), validation::validate_triangles(field, mesh);
  validate_closed(field, mesh);
}

/// Both in integers, in units.
struct Solids {
  template <class Number>
  Solids(const Mesh<Number>& a, const Mesh<Number>& b) {
    std::vector<Point> all;
    for (const Mesh<Number>* mesh : {&a, &b})
      for (const Point3<Number>& p : mesh->vertices) all.push_back(exact(p));
    const IntegerCloud cloud(all);
    unit = cloud.unit;
    const auto middle = cloud.points.begin() + static_cast<std::ptrdiff_t>(a.vertices.size());
    solids.emplace_back(std::vector<Point3<Integer>>(cloud.points.begin(), middle), a.faces, unit);
    solids.emplace_back(std::vector<Point3<Integer>>(middle, cloud.points.end()), b.faces, unit);
  }

  std::vector<Triangle> faces_of(std::size_t solid) const {
    const auto& vertices = solids[solid].vertices();
    std::vector<Triangle> found;
    for (const Face& f : solids[solid].faces()) found.push_back({vertices[f.a], vertices[f.b], vertices[f.c]});
    return found;
  }
  Point actual(const Point& p) const { return {Rational(p.x * unit), Rational(p.y * unit), Rational(p.z * unit)}; }
  Rational actual_square(const Rational& square) const { return Rational(square * unit * unit); }

  std::vector<Solid> solids;
  Rational unit;
};
using FacesOfBoth = std::array<std::vector<Triangle>, 2>;

struct Box {
  std::array<Integer, 3> low, high;

  explicit Box(const std::vector<Triangle>& faces) : low{faces[0].a.x, faces[0].a.y, faces[0].a.z}, high(low) {
    for (const Triangle& t : faces) {
      for (const auto* p : {&t.a, &t.b, &t.c}) {
        const std::array at{&p->x, &p->y, &p->z};
        for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], *at[i]), high[i] = std::max(high[i], *at[i]);
      }
    }
  }
};

/// The gap of two boxes along each axis; negative: their common extent there.
std::array<Integer, 3> gaps(const Box& a, const Box& b) {
  std::array<Integer, 3> found;
  for (std::size_t i = 0; i < 3; ++i) found[i] = std::max(Integer(a.low[i] - b.high[i]), Integer(b.low[i] - a.high[i]));
  return found;
}

bool meet_polyhedron_polyhedron(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
  return true;
}

Integer squared_distance_polyhedron_polyhedron(const Box& a, const Box& b) {
  Integer sum(0);
  for (const Integer& gap : gaps(a, b))
    if (sgn(gap) > 0) sum += gap * gap;
  return sum;
}

/// For two that have no common point.
Rational squared_distance_polyhedron_polyhedron(const Triangle& a, const Triangle& b) {
  std::vector<Rational> displacements;
  for (const auto& [t, other] : {std::pair{&a, &b}, {&b, &a}})
    for (const auto& edge : {Segment3<Integer>{t->a, t->b}, {t->b, t->c}, {t->c, t->a}})
      displacements.push_back(squared_distance_to_touch(edge, *other));
  return *std::min_element(displacements.begin(), displacements.end());
}

std::vector<Box> boxes_of(const std::vector<Triangle>& faces) {
  std::vector<Box> boxes;
  for (const Triangle& face : faces) boxes.emplace_back(std::vector<Triangle>{face});
  return boxes;
}

/// True if all corners of the other triangle are on one side of the plane of a triangle.
bool beside(const Triangle& t, const Triangle& other) {
  const Vector3<Integer> normal = cross(t.b - t.a, t.c - t.a);
  const auto side = [&](const Point3<Integer>& p) { return sgn(dot(normal, p - t.a)); };
  const int first = side(other.a);
  return first != 0 && side(other.b) == first && side(other.c) == first;
}

/// A point on a face of each.
std::optional<Point> common_point_of_faces(const FacesOfBoth& faces) {
  const std::vector<Box> boxes_a = boxes_of(faces[0]), boxes_b = boxes_of(faces[1]);
  for (std::size_t i = 0; i < boxes_a.size(); ++i) {
    for (std::size_t j = 0; j < boxes_b.size(); ++j) {
      if (!meet_polyhedron_polyhedron(boxes_a[i], boxes_b[j])) continue;
      const Triangle &s = faces[0][i], &t = faces[1][j];
      if (beside(s, t) || beside(t, s) || plane_apart({s.a, s.b, s.c}, {t.a, t.b, t.c})) continue;
      const PointOfBoth common = points_of_both(s, t, 0)[0];
      const auto& [u, v, w] = common.on_a;
      return Point{Rational(u * s.a.x + v * s.b.x + w * s.c.x), Rational(u * s.a.y + v * s.b.y + w * s.c.y),
                   Rational(u * s.a.z + v * s.b.z + w * s.c.z)};
    }
  }
  return std::nullopt;
}

/// The distance of the faces of one from those of the other, if none has a common point.
Rational least_squared_distance(const FacesOfBoth& faces) {
  const std::vector<Box> boxes_a = boxes_of(faces[0]), boxes_b = boxes_of(faces[1]);
  struct Pair {
    Integer least;
    std::size_t i, j;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < boxes_a.size(); ++i)
    for (std::size_t j = 0; j < boxes_b.size(); ++j)
      pairs.push_back({squared_distance_polyhedron_polyhedron(boxes_a[i], boxes_b[j]), i, j});
  std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.least < q.least; });
  std::optional<Rational> least;
  for (const auto& [of_boxes, i, j] : pairs) {
    if (least && *least <= of_boxes) break;
    Rational found = squared_distance_polyhedron_polyhedron(faces[0][i], faces[1][j]);
    if (!least || found < *least) least = std::move(found);
  }
  return *least;
}

using Located = Truth<Location>;

std::vector<Certificate> certificates_of(const std::vector<Located>& located) {
  std::vector<Certificate> proofs;
  for (const Located& one : located) proofs.push_back(one.certificate());
  return proofs;
}

void append(std::vector<Rational>& list, const Point& p) { list.insert(list.end(), {p.x, p.y, p.z}); }

/// Cells, with a proof for each that its point is outside.
struct Proved {
  SpacePartition partition;
  std::vector<Located> outside;

  void add_to(Certificate& certificate, const Solids& s) const {
    std::vector<Rational> tree(partition.tree.begin(), partition.tree.end()), planes, points;
    for (const WitnessPlane& plane : partition.planes) {
      const auto& [x, y, z] = plane.normal;
      planes.insert(planes.end(), {Rational(x), Rational(y), Rational(z), Rational(plane.offset * s.unit)});
    }
    for (const Point& p : partition.points) append(points, s.actual(p));
    certificate.facts.insert(certificate.facts.end(), {{"tree", tree}, {"planes", planes}, {"points", points}});
    certificate.parts.emplace_back("outside", certificates_of(outside));
  }
};

Proved cut(const Solids& s, Cells cells) {
  std::vector<Located> outside;
  SpacePartition partition({&s.solids[0], &s.solids[1]}, cells, [&](std::size_t solid, const Point& point) {
    Located located = s.solids[solid].locate(point);
    const Location location = located.answer;
    if (location == Location::outside) outside.push_back(std::move(located));
    return location;
  });
  return {std::move(partition), std::move(outside)};
}

/// The locations of the vertices that faces use in the other solid: those of a first.
struct Vertices {
  explicit Vertices(const Solids& s) {
    std::vector<Point> points;  // of the proofs
    std::vector<std::size_t> others;
    for (const std::size_t solid : {0, 1}) {
      std::set<Index> named;
      for (const Face& f : s.solids[solid].faces()) named.insert({f.a, f.b, f.c});
      for (const Index i : named) {
        const auto& [x, y, z] = s.solids[solid].vertices()[i];
        const Point p{Rational(x), Rational(y), Rational(z)};
        Located located = s.solids[1 - solid].locate_by_three_rays(p);
        if (located.answer == Location::inside) {
          const Rational square = s.actual_square(s.solids[1 - solid].squared_distance(p));
          if (!farthest_in.empty() && square <= *margin) continue;
          farthest_in = {Rational(solid), Rational(i)}, margin = square;
          proofs.assign(1, std::move(located));
        } else if (farthest_in.empty()) {
          proofs.push_back(std::move(located)), points.push_back(p), others.push_back(1 - solid);
        }
      }
    }
    if (!farthest_in.empty()) return;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (margin && sgn(*margin) == 0) return;
      const Rational square = proofs[i].answer == Location::boundary
                                  ? Rational(0)
                                  : s.actual_square(s.solids[others[i]].squared_distance(points[i]));
      margin = margin ? std::min(*margin, square) : square;
    }
  }

  PolyhedraStep step() const {
    return farthest_in.empty() ? PolyhedraStep::edge_against_face : PolyhedraStep::vertex_inside;
  }
  void add_to(Certificate& certificate) const {
    certificate.facts.emplace_back("vertex", farthest_in);
    certificate.parts.emplace_back("vertices", certificates_of(proofs));
  }

  std::vector<Rational> farthest_in;  ///< the solid and the index of the vertex that is farthest inside, or empty
  std::vector<Located> proofs;        ///< for that vertex, or for all
  std::optional<Rational> margin;
};

PolyhedronPolyhedronAnswer apart_by_boxes(const Solids& s, const Box& a, const Box& b, std::size_t axis) {
  const Integer gap = gaps(a, b)[axis], doubled = a.high[axis] < b.low[axis] ? Integer(a.high[axis] + b.low[axis])
                                                                             : Integer(b.high[axis] + a.low[axis]);
  const Rational value = quotient(doubled, Integer(2)) * s.unit;
  return {{Contact::disjoint, PolyhedraStep::bounding_volumes}, s.actual_square(Rational(Integer(gap * gap))), [=] {
            return Certificate{"separating_axis", {{"axis", {Rational(axis)}}, {"value", {value}}}};
          }};
}

/// The margin is that of the faces or, if it is less, the common extent of the boxes along an axis.
PolyhedronPolyhedronAnswer disjoint(const Solids& s, const FacesOfBoth& faces, const Integer& common_length,
                                    Proved proved) {
  const Rational least = std::min(least_squared_distance(faces), Rational(Integer(common_length * common_length)));
  return {
      {Contact::disjoint, PolyhedraStep::edge_against_face}, s.actual_square(least), [s, proved = std::move(proved)] {
        Certificate certificate{"partition", {}};
        proved.add_to(certificate, s);
        return certificate;
      }};
}

/// A common point of both, with its proofs.
Certificate common_point(const char* kind, const Solids& s, const Point& p) {
  Certificate certificate{kind, {}};
  append(certificate.facts.emplace_back("point", std::vector<Rational>{}).second, s.actual(p));
  certificate.parts.emplace_back("in_a", certificates_of({s.solids[0].locate_by_three_rays(p)}));
  certificate.parts.emplace_back("in_b", certificates_of({s.solids[1].locate_by_three_rays(p)}));
  return certificate;
}

PolyhedronPolyhedronAnswer in_contact(const Solids& s, const Point& common) {
  Proved proved = cut(s, Cells::open);
  Vertices vertices(s);
  const auto inside = proved.partition.common;
  if (inside) {
    return {{Contact::overlapping, vertices.step()}, vertices.margin, [=] {
              Certificate certificate = common_point("common_interior_point", s, *inside);
              vertices.add_to(certificate);
              return certificate;
            }};
  }
  return {{Contact::touching, vertices.step()}, Rational(0), [=] {
            Certificate certificate = common_point("touching", s, common);
            proved.add_to(certificate, s), vertices.add_to(certificate);
            return certificate;
          }};
}

template <class Number>
PolyhedronPolyhedronAnswer truth_of_polyhedron_polyhedron(const Mesh<Number>& a, const Mesh<Number>& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  validate_solid("a", a), validate_solid("b", b);
  const Solids s(a, b);
  const FacesOfBoth faces{s.faces_of(0), s.faces_of(1)};
  const Box box_a(faces[0]), box_b(faces[1]);
  const std::array<Integer, 3> between = gaps(box_a, box_b);
  const auto widest = std::max_element(between.begin(), between.end());
  if (sgn(*widest) > 0) return apart_by_boxes(s, box_a, box_b, static_cast<std::size_t>(widest - between.begin()));
  std::optional<Point> common = common_point_of_faces(faces);
  if (!common) {
    Proved proved = cut(s, Cells::closed);
    common = proved.partition.common;
    if (!common) return disjoint(s, faces, *widest, std::move(proved));
  }
  return in_contact(s, *common);
}

}  // namespace

template <Exact Number>
Truth<PolyhedronPolyhedron> polyhedron_polyhedron(const Mesh<Number>& a, const Mesh<Number>& b) {
  return truth_of_polyhedron_polyhedron(a, b);
}
template Truth<PolyhedronPolyhedron> polyhedron_polyhedron(const Meshd&, const Meshd&);
template Truth<PolyhedronPolyhedron> polyhedron_polyhedron(const Mesh<Rational>&, const Mesh<Rational>&);

}  // namespace touchstone::oracle
