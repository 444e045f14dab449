// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"
#include "catalogue/rows/broad_phase/all_pairs.h"
#include "catalogue/rows/lines/explicit_line.h"
#include "catalogue/rows/lines/implicit_circle.h"
#include "catalogue/rows/lines/line_line.h"
#include "catalogue/rows/lines/line_point_at.h"
#include "catalogue/rows/lines/orientation.h"
#include "catalogue/rows/lines/parametric_circle.h"
#include "catalogue/rows/lines/point_on_segment.h"
#include "catalogue/rows/lines/ray_segment.h"
#include "catalogue/rows/lines/segment_segment.h"
#include "catalogue/rows/planes/point_ground_plane.h"
#include "catalogue/rows/planes/point_plane.h"
#include "catalogue/rows/planes/point_plane_toi.h"
#include "catalogue/rows/planes/polygon_normal.h"
#include "catalogue/rows/polygons/convex_partition.h"
#include "catalogue/rows/polygons/interior_angles.h"
#include "catalogue/rows/polygons/point_in_convex_polygon.h"
#include "catalogue/rows/polygons/point_in_polygon.h"
#include "catalogue/rows/polygons/polygon_convexity.h"
#include "catalogue/rows/polygons/polygon_convexity_interior_angles.h"
#include "catalogue/rows/polygons/polygon_polygon.h"
#include "catalogue/rows/polygons/triangulate_polygon.h"
#include "catalogue/rows/polyhedra/point_in_convex_polyhedron.h"
#include "catalogue/rows/response/contact_state.h"
#include "catalogue/rows/response/damped_reflection.h"
#include "catalogue/rows/response/elastic_collision.h"
#include "catalogue/rows/response/inelastic_collision.h"
#include "catalogue/rows/response/kinetic_energy.h"
#include "catalogue/rows/response/momentum.h"
#include "catalogue/rows/response/penalty_force.h"
#include "catalogue/rows/response/reflect_plane.h"
#include "catalogue/rows/response/reflect_wall.h"
#include "catalogue/rows/response/restitution_collision.h"
#include "catalogue/rows/response/rigid_body_collision.h"
#include "catalogue/rows/response/simultaneous_collisions.h"
#include "catalogue/rows/sweeps/swept_aabb_aabb.h"
#include "catalogue/rows/sweeps/swept_convex_polyhedra.h"
#include "catalogue/rows/sweeps/swept_sphere_plane.h"
#include "catalogue/rows/sweeps/swept_sphere_sphere.h"
#include "catalogue/rows/volumes/aabb_aabb.h"
#include "catalogue/rows/volumes/aabb_of_points.h"
#include "catalogue/rows/volumes/bounding_sphere.h"
#include "catalogue/rows/volumes/closest_point_on_aabb.h"
#include "catalogue/rows/volumes/convex_hull.h"
#include "catalogue/rows/volumes/convex_hull_2d.h"
#include "catalogue/rows/volumes/kdop_kdop.h"
#include "catalogue/rows/volumes/kdop_of_points.h"
#include "catalogue/rows/volumes/obb_obb.h"
#include "catalogue/rows/volumes/obb_of_points.h"
#include "catalogue/rows/volumes/point_in_kdop.h"
#include "catalogue/rows/volumes/point_in_obb.h"
#include "catalogue/rows/volumes/sphere_aabb.h"
#include "catalogue/rows/volumes/sphere_sphere.h"

namespace touchstone::catalogue {

template <class... R>
struct RowList {
  template <class Visit>
  static void for_each(const Visit& visit) {
    (visit.template operator()<R>(), ...);
  }
};

/// The catalogue, in the order of the deck. There is no other list of operations.
// clang-format off
using Rows = RowList<
    rows::explicit_line,
    rows::implicit_circle,
    rows::parametric_circle,
    rows::line_point_at,
    rows::point_on_segment,
    rows::line_line,
    rows::segment_segment,
    rows::ray_segment,
    rows::orientation,
    rows::polygon_convexity,
    rows::polygon_convexity_interior_angles,
    rows::interior_angles,
    rows::triangulate_polygon,
    rows::convex_partition,
    rows::point_in_polygon,
    rows::point_in_convex_polygon,
    rows::polygon_polygon,
    rows::point_ground_plane,
    rows::polygon_normal,
    rows::point_plane,
    rows::point_plane_toi,
    rows::aabb_of_points,
    rows::bounding_sphere,
    rows::convex_hull_2d,
    rows::convex_hull,
    rows::kdop_of_points,
    rows::point_in_kdop,
    rows::kdop_kdop,
    rows::sphere_sphere,
    rows::aabb_aabb,
    rows::closest_point_on_aabb,
    rows::sphere_aabb,
    rows::obb_of_points,
    rows::point_in_obb,
    rows::obb_obb,
    rows::swept_sphere_sphere,
    rows::swept_aabb_aabb,
    rows::swept_sphere_plane,
    rows::swept_convex_polyhedra,
    rows::point_in_convex_polyhedron,
    rows::all_pairs,
    rows::momentum,
    rows::kinetic_energy,
    rows::reflect_wall,
    rows::reflect_plane,
    rows::elastic_collision,
    rows::inelastic_collision,
    rows::restitution_collision,
    rows::damped_reflection,
    rows::penalty_force,
    rows::contact_state,
    rows::rigid_body_collision,
    rows::simultaneous_collisions>;
// clang-format on

/// visit.template operator()<Row>() for every row.
template <class Visit>
void for_each_row(const Visit& visit) {
  Rows::for_each(visit);
}

}  // namespace touchstone::catalogue
