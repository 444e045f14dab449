// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/ray_mesh.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/polygon_faces.h"
#include "oracle/exact/solids/ray_part.h"

namespace touchstone::oracle {
namespace {
/// A plane that has the cut ray in front of it, and these faces behind.
struct Missed {
  WitnessPlane plane;
  std::vector<Rational> faces;
};
struct Met {
  Index face;
  RayPart part;
};

struct Cast {
  CutRay ray;
  Rational unit;
  std::vector<Missed> missed;
  std::vector<Met> met;

  Rational actual(const Rational& length) const { return Rational(length * unit); }

  void ask(Index face, const Triangle3<Integer>& t) {
    for (Missed& plane : missed) {
      const auto behind = [&](const Point3<Integer>& p) {
        const auto& [x, y, z] = plane.plane.normal;
        return Rational(x * p.x + y * p.y + z * p.z) < plane.plane.offset;
      };
      if (behind(t.a) && behind(t.b) && behind(t.c)) return plane.faces.emplace_back(face), void();
    }
    RayPart part(ray, t);
    if (part.any()) met.push_back({face, std::move(part)});
    else missed.push_back({part.between(), {Rational(face)}});
  }
  /// The first t counts, and of equal ones the least index.
  const Met& first() const {
    return *std::min_element(met.begin(), met.end(),
                             [](const Met& a, const Met& b) { return a.part.first_t() < b.part.first_t(); });
  }
  /// corners_of(face): those of a named one.
  template <class CornersOf>
  RayMesh<Rational> answer(const std::vector<Index>& named, const CornersOf& corners_of) const {
    if (met.empty()) return {PassageRelation::none, {}, 0};
    const auto& [triangle, part] = first();
    const Index face = named[triangle];
    const Point3<Rational> p = part.first_point();
    const FaceHit<Rational> hit{
        part.first_t(), {actual(p.x), actual(p.y), actual(p.z)}, face, face_part(corners_of(face), p)};
    std::set<Index> faces;
    for (const Met& each : met) faces.insert(named[each.face]);
    return {PassageRelation::hit, hit, static_cast<Index>(faces.size())};
  }
  Certificate certificate() const {
    const auto in_units = [this](const Rational& length) { return actual(length); };
    std::vector<Certificate> planes, proofs;
    for (const auto& [plane, faces] : missed)
      planes.push_back({"separating_plane", {{"plane", numbers_of(plane, in_units)}, {"faces", faces}}});
    for (const auto& [face, part] : met) {
      proofs.push_back(part.of_first(in_units));
      proofs.back().facts.insert(proofs.back().facts.begin(), {"face", {Rational(face)}});
    }
    return {"faces", {{"until", {Rational(ray.until)}}}, {{"missed", std::move(planes)}, {"met", std::move(proofs)}}};
  }
};

template <class Number>
Truth<RayMesh<Rational>> truth_of_ray_mesh(const Ray3<Number>& given, const Mesh<Number>& mesh) {
  validation::validate_numbers("ray", given), validation::validate_numbers("mesh", mesh);
  validation::validate("ray", given), validation::validate("mesh", mesh);
  validate_polygons("mesh", mesh);
  const auto& [o, v] = given;
  std::vector<Point3<Number>> points = mesh.vertices;
  points.push_back(o), points.push_back({v.x, v.y, v.z});
  const IntegerCloud cloud(points);
  const Point3<Integer>& origin = cloud.points[mesh.vertices.size()];
  const Vector3<Integer> direction = cloud.points.back() - Point3<Integer>{0, 0, 0};
  std::vector<Point3<Integer>> corners;
  for (const auto& [a, b, c] : mesh.faces)
    for (const Index corner : {a, b, c}) corners.push_back(cloud[corner]);
  if (corners.empty()) corners.push_back(origin);
  Cast cast{cut_ray(origin, direction, corners), cloud.unit, {}, {}};
  std::optional<Rational> margin;
  const auto consider = [&margin](const Rational& square) { margin = margin ? std::min(*margin, square) : square; };
  for (Index i = 0; i < mesh.faces.size(); ++i) {
    const Triangle3<Integer> t{corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]};
    cast.ask(i, t);
    consider(squared_distance_to_touch(cast.ray.segment, t));
  }
  const std::vector<Index> named = named_face_of_each(mesh);
  const RayMesh<Rational> answer = cast.answer(named, [&](Index face) {
    std::vector<Point3<Rational>> ring;
    for (const Index i : corners_of_named(mesh, face)) ring.push_back(exact(cloud[i]));
    return ring;
  });
  for (const auto& [face, part] : cast.met) {
    const Rational after(part.first_t() - answer.first->t);
    if (named[face] != answer.first->face) consider(Rational(after * after * Rational(dot(direction, direction))));
  }
  if (margin) *margin *= cloud.unit * cloud.unit;
  return {answer, margin, [cast = std::move(cast)] { return cast.certificate(); }};
}

}  // namespace

template <Exact Number>
Truth<RayMesh<Rational>> ray_mesh(const Ray3<Number>& ray, const Mesh<Number>& mesh) {
  return truth_of_ray_mesh(ray, mesh);
}
template Truth<RayMesh<Rational>> ray_mesh(const Ray3d&, const Meshd&);
template Truth<RayMesh<Rational>> ray_mesh(const Ray3<Rational>&, const Mesh<Rational>&);

}  // namespace touchstone::oracle
