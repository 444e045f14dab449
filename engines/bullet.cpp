// SPDX-License-Identifier: Apache-2.0
// Bullet as peer, in single precision: narrow phase, sweeps, hulls, and one contact of two balls.
#include <bullet/LinearMath/btConvexHullComputer.h>
#include <touchstone/program/engine_main.h>
#include <touchstone/robust/planes/capsule_plane.h>

#include "bullet_shapes.h"
#include "depth.h"
#include "one_hit.h"
#include "surfaces.h"

using namespace touchstone;
using namespace touchstone::bullet_shapes;

/// What it says of touching is not documented. Margins lie within balls and boxes; that of a convex hull, which lies
/// outside, is set to 0. Boxes and motions that it cannot hold exactly are left out.
struct Bullet {
  static constexpr const char* name = "Bullet 3.24";
  using number = float;

  using Hit = std::optional<bool>;
  using Motion = MaybeContact;
  using Ball = Sphere3<float>;
  using Slabs = Aabb3<float>;
  using Turned = Obb3<float>;
  using Capsule = Capsule3<float>;
  using Corners = Triangle3<float>;
  using Velocity = Vector3<float>;

  Hit sphere_sphere(const Ball& a, const Ball& b) { return meet(ball(a), ball(b)); }
  Hit sphere_aabb(const Ball& sphere, const Slabs& aabb) { return meet(ball(sphere), solid(aabb)); }
  Hit aabb_aabb(const Slabs& a, const Slabs& b) { return meet(solid(a), solid(b)); }
  /// As boxes if both are upright, else as convex hulls of eight corners.
  Hit obb_obb(const Turned& a, const Turned& b) {
    const auto first = exactly::upright(a), second = exactly::upright(b);
    if (first && second) return meet(solid(first), solid(second));
    return meet(eight_corners(a), eight_corners(b));
  }
  Hit aabb_obb(const Slabs& aabb, const Turned& obb) { return meet(solid(aabb), solid(obb)); }
  Hit sphere_obb(const Ball& sphere, const Turned& obb) { return meet(ball(sphere), solid(obb)); }
  Hit sphere_triangle(const Ball& sphere, const Corners& t) { return meet(ball(sphere), triangle(t)); }
  Hit sphere_capsule(const Ball& sphere, const Capsule& capsule) { return meet(ball(sphere), solid(capsule)); }
  Hit sphere_convex(const Ball& sphere, const Mesh<float>& mesh) { return meet(ball(sphere), hull(mesh.vertices)); }
  Hit capsule_capsule(const Capsule& a, const Capsule& b) { return meet(solid(a), solid(b)); }
  Hit capsule_plane(const Capsule& capsule, const Plane<float>& plane) { return meet(solid(capsule), behind(plane)); }
  Hit capsule_triangle(const Capsule& capsule, const Corners& t) { return meet(solid(capsule), triangle(t)); }
  Hit capsule_aabb(const Capsule& capsule, const Slabs& aabb) { return meet(solid(capsule), solid(aabb)); }
  Hit capsule_obb(const Capsule& capsule, const Turned& obb) { return meet(solid(capsule), solid(obb)); }
  Hit capsule_convex(const Capsule& capsule, const Mesh<float>& mesh) {
    return meet(solid(capsule), hull(mesh.vertices));
  }
  Hit obb_plane(const Turned& obb, const Plane<float>& plane) { return meet(solid(obb), behind(plane)); }
  Hit triangle_obb(const Corners& t, const Turned& obb) { return meet(triangle(t), solid(obb)); }
  Hit triangle_triangle(const Corners& a, const Corners& b) { return meet(triangle(a), triangle(b)); }
  /// As concave meshes (GImpact), which are surfaces, without their margin.
  Hit polyhedron_polyhedron(const Mesh<float>& a, const Mesh<float>& b) {
    if (!surfaces::decide(a, b)) return std::nullopt;
    Surface first(a), second(b);
    return meet(Placed{first.moving()}, Placed{second.moving()});
  }

  /// As convex hulls with the radii as their margins. Depth and normal are those of the deepest contact; of solids that
  /// are far apart it gives none.
  std::optional<Penetration<float>> penetration(const Mesh<float>& a, const Mesh<float>& b, float radius_a,
                                                float radius_b) {
    const Deepest found = deepest(hull(a.vertices, radius_a), hull(b.vertices, radius_b));
    if (!found.distance) return depth::apart(a, b, radius_a, radius_b);
    return depth::answer(a, b, radius_a, radius_b, -*found.distance, back(found.from_b));
  }

  /// One moves, the other rests: the difference of the velocities is exact.
  Motion swept_sphere_sphere(const Ball& a, const Ball& b, const Velocity& velocity_a, const Velocity& velocity_b) {
    const auto velocity = exactly::difference(velocity_a, velocity_b);
    if (!velocity) return std::nullopt;
    return first_contact(ball(a), *velocity, ball(b));
  }
  Motion swept_aabb_aabb(const Slabs& a, const Slabs& b, const Velocity& velocity) {
    return first_contact(solid(a), velocity, solid(b));
  }
  Motion swept_obb_obb(const Turned& a, const Turned& b, const Velocity& velocity) {
    return first_contact(solid(a), velocity, solid(b));
  }
  Motion swept_convex_polyhedra(const Mesh<float>& a, const Mesh<float>& b, const Velocity& velocity) {
    return first_contact(hull(a.vertices), velocity, hull(b.vertices));
  }
  Motion swept_sphere_aabb(const Ball& sphere, const Velocity& velocity, const Slabs& aabb) {
    return first_contact(ball(sphere), velocity, solid(aabb));
  }
  Motion swept_sphere_triangle(const Ball& sphere, const Velocity& velocity, const Corners& t) {
    return first_contact(ball(sphere), velocity, triangle(t));
  }
  /// As a mesh at rest, without its margin. Which of several faces it names is not documented: none is.
  std::optional<FirstFaceContact<float>> swept_sphere_mesh(const Ball& sphere, const Velocity& velocity,
                                                           const Mesh<float>& mesh) {
    if (mesh.faces.empty()) return std::nullopt;
    Surface surface(mesh);
    const Motion found = first_contact(ball(sphere), velocity, Placed{surface.resting()});
    if (!found) return std::nullopt;
    return FirstFaceContact<float>{found->relation, found->t, {}};
  }
  /// Its plane has a half-space behind it: where the capsule starts in front, that is the same question.
  Motion swept_capsule_plane(const Capsule& capsule, const Velocity& velocity, const Plane<float>& plane) {
    const auto& [a, b] = capsule.segment;
    const Plane<double> exact{{plane.normal.x, plane.normal.y, plane.normal.z}, plane.offset};
    const Capsule3d same{{surfaces::in_double(a), surfaces::in_double(b)}, capsule.radius};
    if (robust::capsule_plane(same, exact) != Contact::disjoint) return std::nullopt;
    return first_contact(solid(capsule), velocity, behind(plane));
  }
  Motion swept_capsule_capsule(const Capsule& a, const Capsule& b, const Velocity& velocity) {
    return first_contact(solid(a), velocity, solid(b));
  }

  Hit segment_sphere(const Segment3<float>& s, const Ball& sphere) { return cast(s, ball(sphere)); }
  Hit segment_aabb(const Segment3<float>& s, const Slabs& aabb) { return cast(s, solid(aabb)); }
  Hit segment_obb(const Segment3<float>& s, const Turned& obb) { return cast(s, solid(obb)); }
  Hit segment_capsule(const Segment3<float>& s, const Capsule& capsule) { return cast(s, solid(capsule)); }
  Hit segment_triangle(const Segment3<float>& s, const Corners& t) { return cast(s, triangle(t)); }

  /// Documented: faces are planar n-gons; no word of flat input. They are cut into triangles from their first corner.
  ConvexHull convex_hull(const std::vector<Point3<float>>& points) {
    btConvexHullComputer hull;
    hull.compute(&points[0].x, sizeof(points[0]), static_cast<int>(points.size()), 0, 0);
    const auto index = [&](int vertex) { return static_cast<Index>(hull.original_vertex_index[vertex]); };
    if (hull.vertices.size() == 1) return {0, index(0), {}, {}, {}};
    if (hull.vertices.size() == 2) return {1, {}, IndexPair{index(0), index(1)}, {}, {}};
    std::vector<Face> faces;
    std::vector<Index> ring;
    for (int k = 0; k < hull.faces.size(); ++k) {
      const btConvexHullComputer::Edge *first = &hull.edges[hull.faces[k]], *edge = first;
      ring.clear();
      do {
        ring.push_back(index(edge->getSourceVertex()));
        edge = edge->getNextEdgeOfFace();
      } while (edge != first && ring.size() <= points.size());
      for (std::size_t i = 2; i < ring.size(); ++i) faces.push_back({ring[0], ring[i - 1], ring[i]});
    }
    const bool flat = hull.faces.size() <= 2;
    if (flat) return {2, {}, {}, ring, {}};
    return {3, {}, {}, {}, faces};
  }

  /// A relative velocity below 0.2 has no restitution, by its documentation: left out.
  std::optional<Velocities<float>> restitution_collision(const Masses<float>& masses,
                                                         const Velocities<float>& velocities,
                                                         const Vector3<float>& normal, float e) {
    const auto hit = exactly::hit(velocities, normal);
    if (!hit || hit->approach <= 0.2) return std::nullopt;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broad_phase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broad_phase, &solver, &configuration);
    world.setGravity(btVector3(0, 0, 0));
    btSphereShape both(hit->distance / 2);
    btRigidBody a(body(both, masses.first, 1)), b(body(both, masses.second, e));
    a.setLinearVelocity(vector(velocities.first));
    b.setLinearVelocity(vector(velocities.second));
    b.setWorldTransform(at(vector(hit->between)));
    for (btRigidBody* one : {&a, &b}) {
      one->setActivationState(DISABLE_DEACTIVATION);
      world.addRigidBody(one);
    }
    world.stepSimulation(1.0F / 64, 0);
    const Velocities<float> after{back(a.getLinearVelocity()), back(b.getLinearVelocity())};
    world.removeRigidBody(&b);
    world.removeRigidBody(&a);
    return after;
  }
  std::optional<Velocities<float>> elastic_collision(const Masses<float>& masses, const Velocities<float>& velocities,
                                                     const Vector3<float>& normal) {
    return restitution_collision(masses, velocities, normal, 1);
  }

 private:
  static btRigidBody::btRigidBodyConstructionInfo body(btSphereShape& shape, float mass, float restitution) {
    btVector3 inertia(0, 0, 0);
    shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_restitution = restitution;
    info.m_friction = 0;
    return info;
  }
};

TOUCHSTONE_ENGINE_MAIN(Bullet)
