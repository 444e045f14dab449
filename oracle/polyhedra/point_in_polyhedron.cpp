// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/point_in_polyhedron.h"

#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/closed_mesh.h"
#include "oracle/exact/solids/polygon_faces.h"
#include "oracle/exact/solids/solid.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Location> point_in_polyhedron(const Mesh<Number>& mesh, const Point3<Number>& point) {
  validation::validate_numbers("mesh", mesh), validation::validate_numbers("point", point);
  validation::validate("mesh", mesh), validate_polygons("mesh", mesh), validation::validate_triangles("mesh", mesh);
  validate_closed("mesh", mesh);
  std::vector<Point3<Number>> points = mesh.vertices;
  points.push_back(point);
  IntegerCloud cloud(points);
  const Point3<Rational> p{Rational(cloud.points.back().x), Rational(cloud.points.back().y),
                           Rational(cloud.points.back().z)};
  cloud.points.pop_back();
  const Solid solid(std::move(cloud.points), mesh.faces, cloud.unit);
  Truth<Location> found = solid.locate_by_three_rays(p);
  if (found.answer != Location::boundary) found.margin = Rational(solid.squared_distance(p) * cloud.unit * cloud.unit);
  return found;
}
template Truth<Location> point_in_polyhedron(const Meshd&, const Point3d&);
template Truth<Location> point_in_polyhedron(const Mesh<Rational>&, const Point3<Rational>&);

}  // namespace touchstone::oracle
