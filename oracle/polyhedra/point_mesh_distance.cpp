// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/point_mesh_distance.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/solids/closed_mesh.h"
#include "oracle/exact/solids/nearest_on_surface.h"
#include "oracle/exact/solids/polygon_faces.h"

namespace touchstone::oracle {
namespace {

template <class Number>
PointAndSurface point_and_surface(const Point3<Number>& point, const Mesh<Number>& mesh) {
  std::vector<Point3<Number>> points = mesh.vertices;
  points.push_back(point);
  return {IntegerCloud(points), mesh.faces};
}

template <class Number>
MeshPoint<Surd> mesh_point(const PointAndSurface& both, const Mesh<Number>& mesh, const NearPlace& near) {
  const Index face = named_face_of_each(mesh)[near.triangle];
  std::vector<Point3<Rational>> corners;
  for (const Index i : corners_of_named(mesh, face)) corners.push_back(both.vertex(i));
  return {in_space(both.actual(near.point)), face, face_part(corners, near.point)};
}

template <class Number>
Truth<PointMeshDistance<Surd>> truth_of_point_mesh_distance(const Point3<Number>& point, const Mesh<Number>& mesh) {
  validation::validate_numbers("point", point), validation::validate_numbers("mesh", mesh);
  validation::validate("mesh", mesh), validate_polygons("mesh", mesh), validation::validate_triangles("mesh", mesh);
  validate_closed("mesh", mesh);
  const PointAndSurface both = point_and_surface(point, mesh);
  const std::vector<NearPlace> all = both.nearest();
  const NearPlace& first = first_of(all);
  const Truth<Location> location = both.solid.locate_by_three_rays(both.point);
  const Rational square(both.square * both.unit * both.unit);
  auto truth = truth_of_distance(PointMeshDistance<Surd>{location.answer, mesh_point(both, mesh, first), {}, {}, {}},
                                 square, {{"face", {Rational(first.triangle)}}, {"weights", first.weights}});
  const Surd& distance = truth.answer.distance;
  truth.answer.signed_distance = location.answer == Location::inside ? Surd(-distance) : distance;
  truth.margin = square;
  truth.certificate = [of_distance = std::move(truth.certificate), of_location = location.certificate] {
    Certificate found = of_distance();
    found.parts = {{"location", {of_location()}}};
    return found;
  };
  return truth;
}

}  // namespace

PointMeshDistance<Surd> as_near(const Point3d& point, const Meshd& mesh, const PointMeshDistance<Surd>& truth,
                                const Point3d& other) {
  const PointAndSurface both = point_and_surface(point, mesh);
  const std::vector<NearPlace> all = both.nearest();
  const auto off = [&both, q = exact(other)](const NearPlace& near) {
    const Vector3<Rational> v = both.actual(near.point) - q;
    return Rational(dot(v, v));
  };
  const auto nearest =
      std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
  PointMeshDistance<Surd> found = truth;
  found.nearest = mesh_point(both, mesh, *nearest);
  return found;
}

template <Exact Number>
Truth<PointMeshDistance<Surd>> point_mesh_distance(const Point3<Number>& point, const Mesh<Number>& mesh) {
  return truth_of_point_mesh_distance(point, mesh);
}
template Truth<PointMeshDistance<Surd>> point_mesh_distance(const Point3d&, const Meshd&);
template Truth<PointMeshDistance<Surd>> point_mesh_distance(const Point3<Rational>&, const Mesh<Rational>&);

}  // namespace touchstone::oracle
