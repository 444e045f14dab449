// SPDX-License-Identifier: Apache-2.0
// FCL as peer: its narrow phase over doubles with libccd, and continuous collision by conservative advancement.
#include <touchstone/program/engine_main.h>

#include <stdexcept>

#include "depth.h"
#include "fcl_shapes.h"
#include "surfaces.h"

using namespace touchstone;
using namespace touchstone::fcl_shapes;

/// What it says of touching is not documented; nor is a tolerance of its answers as a length. Boxes that it cannot hold
/// exactly by center and size are left out, and motions whose end is not exact.
struct Fcl {
  static constexpr const char* name = "FCL " FCL_VERSION " with libccd";

  using Hit = std::optional<bool>;
  using Motion = std::optional<FirstContact<double>>;

  Hit sphere_sphere(const Sphere3d& a, const Sphere3d& b) { return meet(ball(a), ball(b)); }
  Hit sphere_aabb(const Sphere3d& sphere, const Aabb3d& aabb) { return meet(ball(sphere), solid(aabb)); }
  Hit aabb_aabb(const Aabb3d& a, const Aabb3d& b) { return meet(solid(a), solid(b)); }
  /// As boxes if both are upright, else as convex solids of eight corners.
  Hit obb_obb(const Obb3d& first, const Obb3d& second) {
    const auto a = exactly::upright(first), b = exactly::upright(second);
    if (a && b) return meet(solid(a), solid(b));
    return meet(eight_corners(first), eight_corners(second));
  }
  Hit aabb_obb(const Aabb3d& aabb, const Obb3d& obb) { return meet(solid(aabb), solid(obb)); }
  Hit sphere_obb(const Sphere3d& sphere, const Obb3d& obb) { return meet(ball(sphere), solid(obb)); }
  Hit sphere_convex(const Sphere3d& sphere, const Meshd& mesh) { return meet(ball(sphere), convex(mesh)); }
  Hit sphere_triangle(const Sphere3d& sphere, const Triangle3d& t) { return meet(ball(sphere), surface(t)); }
  Hit sphere_capsule(const Sphere3d& sphere, const Capsule3d& capsule) { return meet(ball(sphere), solid(capsule)); }
  Hit capsule_capsule(const Capsule3d& a, const Capsule3d& b) { return meet(solid(a), solid(b)); }
  Hit capsule_plane(const Capsule3d& capsule, const Plane<double>& plane) {
    return meet(solid(capsule), across_axis<fcl::Halfspaced>(plane));
  }
  Hit capsule_triangle(const Capsule3d& capsule, const Triangle3d& t) { return meet(solid(capsule), surface(t)); }
  Hit capsule_aabb(const Capsule3d& capsule, const Aabb3d& aabb) { return meet(solid(capsule), solid(aabb)); }
  Hit capsule_obb(const Capsule3d& capsule, const Obb3d& obb) { return meet(solid(capsule), solid(obb)); }
  Hit capsule_convex(const Capsule3d& capsule, const Meshd& mesh) { return meet(solid(capsule), convex(mesh)); }
  Hit obb_plane(const Obb3d& obb, const Plane<double>& plane) {
    return meet(solid(obb), across_axis<fcl::Halfspaced>(plane));
  }
  Hit triangle_obb(const Triangle3d& t, const Obb3d& obb) { return meet(surface(t), solid(obb)); }

  Motion swept_sphere_sphere(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                             const Vector3d& velocity_b) {
    const Placed first = ball(a), second = ball(b);
    const auto end_a = end_of(first, velocity_a), end_b = end_of(second, velocity_b);
    if (!end_a || !end_b) return std::nullopt;
    return first_contact(first, *end_a, second, *end_b);
  }
  Motion swept_aabb_aabb(const Aabb3d& a, const Aabb3d& b, const Vector3d& velocity) {
    return first_contact(solid(a), velocity, solid(b));
  }
  Motion swept_obb_obb(const Obb3d& a, const Obb3d& b, const Vector3d& velocity) {
    return first_contact(solid(a), velocity, solid(b));
  }
  Motion swept_convex_polyhedra(const Meshd& a, const Meshd& b, const Vector3d& velocity) {
    return first_contact(convex(a), velocity, convex(b));
  }
  Motion swept_sphere_aabb(const Sphere3d& sphere, const Vector3d& velocity, const Aabb3d& aabb) {
    return first_contact(ball(sphere), velocity, solid(aabb));
  }
  Motion swept_sphere_triangle(const Sphere3d& sphere, const Vector3d& velocity, const Triangle3d& t) {
    return first_contact(ball(sphere), velocity, surface(t));
  }
  /// Which of several faces it names is not documented: none is.
  std::optional<FirstFaceContact<double>> swept_sphere_mesh(const Sphere3d& sphere, const Vector3d& velocity,
                                                            const Meshd& mesh) {
    if (mesh.faces.empty()) return std::nullopt;
    const Motion found = first_contact(ball(sphere), velocity, surface(mesh));
    if (!found) return std::nullopt;
    return FirstFaceContact<double>{found->relation, found->t, {}};
  }
  Motion swept_capsule_plane(const Capsule3d& capsule, const Vector3d& velocity, const Plane<double>& plane) {
    return first_contact(solid(capsule), velocity, across_axis<fcl::Planed>(plane));
  }
  Motion swept_capsule_capsule(const Capsule3d& a, const Capsule3d& b, const Vector3d& velocity) {
    return first_contact(solid(a), velocity, solid(b));
  }

  /// By its GJK; of solids that meet it says -1. Of many pairs of nearest points it promises no particular one: points
  /// are left out.
  ConvexDistance<double> convex_distance(const Meshd& a, const Meshd& b) {
    const double distance = gap(convex(a), convex(b)).min_distance;
    if (distance <= 0) return {ConvexRelation::meeting, {}, {}, 0, 0};
    return {ConvexRelation::apart, {}, {}, distance * distance, distance};
  }

  /// Without radii: it does not round solids. Depth and normal, "pointing from o1 to o2", are those of `collide`, by
  /// libccd's MPR; the documentation of the depth says "penetration depth" and no more. Where solids do not collide,
  /// the gap is that of `distance`.
  std::optional<Penetration<double>> penetration(const Meshd& a, const Meshd& b, double radius_a, double radius_b) {
    if (radius_a != 0 || radius_b != 0) return std::nullopt;
    const Placed p = convex(a), q = convex(b);
    const fcl::CollisionObjectd first(p.shape, p.at), second(q.shape, q.at);
    fcl::CollisionResultd result;
    if (fcl::collide(&first, &second, fcl::CollisionRequestd(/*contacts*/ 1, /*enabled*/ true), result) > 0) {
      const fcl::Contactd& contact = result.getContact(0);
      return depth::answer<double>(a, b, 0, 0, contact.penetration_depth, vector(-contact.normal));
    }
    const fcl::DistanceResultd apart = gap(p, q);
    if (apart.min_distance <= 0) throw std::runtime_error("collide() finds no contact, distance() no gap");
    const fcl::Vector3d beyond = apart.nearest_points[0] - apart.nearest_points[1];
    return depth::answer<double>(a, b, 0, 0, -apart.min_distance, vector(beyond / apart.min_distance));
  }

  /// As meshes of one triangle.
  bool triangle_triangle(const Triangle3d& a, const Triangle3d& b) { return meet(surface(a), surface(b)); }
  /// Its meshes are surfaces.
  Hit polyhedron_polyhedron(const Meshd& a, const Meshd& b) {
    if (!surfaces::decide(a, b)) return std::nullopt;
    return meet(surface(a), surface(b));
  }

 private:
  static Vector3d vector(const fcl::Vector3d& v) { return {v[0], v[1], v[2]}; }
  static fcl::DistanceResultd gap(const Placed& a, const Placed& b) {
    const fcl::CollisionObjectd first(a.shape, a.at), second(b.shape, b.at);
    fcl::DistanceResultd result;
    fcl::distance(&first, &second, fcl::DistanceRequestd(/*nearest points*/ true), result);
    return result;
  }
};

TOUCHSTONE_ENGINE_MAIN(Fcl)
