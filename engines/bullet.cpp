// SPDX-License-Identifier: Apache-2.0
// Bullet as peer, in single precision: narrow phase, sweeps, hulls, and one contact of two balls.
#include <bullet/BulletCollision/CollisionShapes/btTriangleShape.h>
#include <bullet/BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <bullet/BulletCollision/Gimpact/btGImpactShape.h>
#include <bullet/LinearMath/btConvexHullComputer.h>
#include <bullet/btBulletDynamicsCommon.h>
#include <touchstone/program/engine_main.h>

#include <memory>

#include "exactly.h"
#include "one_hit.h"
#include "surfaces.h"

using namespace touchstone;

/// What it says of touching is not documented. Margins lie within balls and boxes; that of a convex hull, which lies
/// outside, is set to 0. Boxes and motions that it cannot hold exactly are left out.
struct Bullet {
  static constexpr const char* name = "Bullet 3.24";
  using number = float;

  using Ball = Sphere3<float>;
  using Slabs = Aabb3<float>;
  using Motion = std::optional<FirstContact<float>>;

  std::optional<bool> sphere_sphere(const Ball& a, const Ball& b) {
    btSphereShape first(a.radius), second(b.radius);
    return meet(first, a.center, second, b.center);
  }
  std::optional<bool> sphere_aabb(const Ball& sphere, const Slabs& aabb) {
    const auto box = exactly::box(aabb);
    if (!box) return std::nullopt;
    btSphereShape first(sphere.radius);
    btBoxShape second(vector(box->half));
    return meet(first, sphere.center, second, box->center);
  }
  std::optional<bool> aabb_aabb(const Slabs& a, const Slabs& b) { return meet(exactly::box(a), exactly::box(b)); }
  /// As boxes if both are upright, else as convex hulls of eight corners.
  std::optional<bool> obb_obb(const Obb3<float>& a, const Obb3<float>& b) {
    const auto first = exactly::upright(a), second = exactly::upright(b);
    if (first && second) return meet(first, second);
    const auto p = exactly::corners(a), q = exactly::corners(b);
    if (!p || !q) return std::nullopt;
    btConvexHullShape of_a, of_b;
    fill(of_a, *p);
    fill(of_b, *q);
    return meet(of_a, {0, 0, 0}, of_b, {0, 0, 0});
  }

  /// One moves, the other rests: the difference of the velocities is exact.
  Motion swept_sphere_sphere(const Ball& a, const Ball& b, const Vector3<float>& velocity_a,
                             const Vector3<float>& velocity_b) {
    const auto velocity = exactly::difference(velocity_a, velocity_b);
    if (!velocity) return std::nullopt;
    btSphereShape first(a.radius), second(b.radius);
    return first_contact(first, a.center, *velocity, second, b.center);
  }
  Motion swept_aabb_aabb(const Slabs& a, const Slabs& b, const Vector3<float>& velocity) {
    const auto first = exactly::box(a), second = exactly::box(b);
    if (!first || !second) return std::nullopt;
    btBoxShape moving(vector(first->half)), resting(vector(second->half));
    return first_contact(moving, first->center, velocity, resting, second->center);
  }
  Motion swept_convex_polyhedra(const Mesh<float>& a, const Mesh<float>& b, const Vector3<float>& velocity) {
    btConvexHullShape moving, resting;
    fill(moving, a.vertices);
    fill(resting, b.vertices);
    return first_contact(moving, {0, 0, 0}, velocity, resting, {0, 0, 0});
  }

  bool triangle_triangle(const Triangle3<float>& a, const Triangle3<float>& b) {
    btTriangleShape first(vector(a.a), vector(a.b), vector(a.c)), second(vector(b.a), vector(b.b), vector(b.c));
    first.setMargin(0), second.setMargin(0);
    return meet(first, {0, 0, 0}, second, {0, 0, 0});
  }

  /// As concave meshes (GImpact), which are surfaces, without their margin.
  std::optional<bool> polyhedron_polyhedron(const Mesh<float>& a, const Mesh<float>& b) {
    if (!surfaces::decide(a, b)) return std::nullopt;
    Surface first(a), second(b);
    return meet(first.shape(), {0, 0, 0}, second.shape(), {0, 0, 0});
  }

  /// Rays of Bullet end.
  std::optional<bool> segment_sphere(const Segment3<float>& s, const Ball& ball) {
    btSphereShape shape(ball.radius);
    return cast(s, shape, ball.center);
  }
  std::optional<bool> segment_aabb(const Segment3<float>& s, const Slabs& aabb) {
    const auto box = exactly::box(aabb);
    if (!box) return std::nullopt;
    btBoxShape shape(vector(box->half));
    return cast(s, shape, box->center);
  }
  std::optional<bool> segment_triangle(const Segment3<float>& s, const Triangle3<float>& t) {
    btTriangleShape shape(vector(t.a), vector(t.b), vector(t.c));
    shape.setMargin(0);
    return cast(s, shape, {0, 0, 0});
  }
  bool sphere_triangle(const Ball& ball, const Triangle3<float>& t) {
    btSphereShape first(ball.radius);
    btTriangleShape second(vector(t.a), vector(t.b), vector(t.c));
    second.setMargin(0);
    return meet(first, ball.center, second, {0, 0, 0});
  }

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
    btSphereShape ball(hit->distance / 2);
    btRigidBody a(body(ball, masses.first, 1)), b(body(ball, masses.second, e));
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
  struct Touch : btCollisionWorld::ContactResultCallback {
    bool found = false;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
      found = found || point.getDistance() <= 0;
      return 0;
    }
  };

  static btVector3 vector(const Vector3<float>& v) { return {v.x, v.y, v.z}; }
  static btVector3 vector(const Point3<float>& p) { return {p.x, p.y, p.z}; }
  static Vector3<float> back(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
  static btTransform at(const btVector3& p) { return btTransform(btQuaternion::getIdentity(), p); }
  static btTransform at(const Point3<float>& p) { return at(btVector3(p.x, p.y, p.z)); }
  static void fill(btConvexHullShape& shape, const std::vector<Point3<float>>& points) {
    shape.setMargin(0);
    for (const Point3<float>& p : points) shape.addPoint(btVector3(p.x, p.y, p.z), false);
    shape.recalcLocalAabb();
  }
  static btRigidBody::btRigidBodyConstructionInfo body(btSphereShape& shape, float mass, float restitution) {
    btVector3 inertia(0, 0, 0);
    shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_restitution = restitution;
    info.m_friction = 0;
    return info;
  }

  /// The numbers stay where the shape reads them.
  class Surface {
   public:
    explicit Surface(const Mesh<float>& mesh) : vertices_(mesh.vertices) {
      for (const Face& face : mesh.faces)
        for (const Index corner : {face.a, face.b, face.c}) corners_.push_back(static_cast<int>(corner));
      triangles_ = std::make_unique<btTriangleIndexVertexArray>(
          static_cast<int>(mesh.faces.size()), corners_.data(), static_cast<int>(3 * sizeof(int)),
          static_cast<int>(vertices_.size()), &vertices_[0].x, static_cast<int>(sizeof(vertices_[0])));
      shape_ = std::make_unique<btGImpactMeshShape>(triangles_.get());
      shape_->setMargin(0);
      shape_->updateBound();
    }
    btGImpactMeshShape& shape() { return *shape_; }

   private:
    std::vector<Point3<float>> vertices_;
    std::vector<int> corners_;
    std::unique_ptr<btTriangleIndexVertexArray> triangles_;
    std::unique_ptr<btGImpactMeshShape> shape_;
  };

  static bool meet(btCollisionShape& a, const Point3<float>& at_a, btCollisionShape& b, const Point3<float>& at_b) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher);
    btDbvtBroadphase broad_phase;
    btCollisionWorld world(&dispatcher, &broad_phase, &configuration);
    btCollisionObject first, second;
    first.setCollisionShape(&a);
    second.setCollisionShape(&b);
    first.setWorldTransform(at(at_a));
    second.setWorldTransform(at(at_b));
    Touch touch;
    world.contactPairTest(&first, &second, touch);
    return touch.found;
  }
  using MaybeBox = std::optional<exactly::Box<float>>;
  static std::optional<bool> meet(const MaybeBox& a, const MaybeBox& b) {
    if (!a || !b) return std::nullopt;
    btBoxShape first(vector(a->half)), second(vector(b->half));
    return meet(first, a->center, second, b->center);
  }

  /// What it answers about a ray that starts in the shape is not documented.
  static std::optional<bool> cast(const Segment3<float>& s, btConvexShape& shape, const Point3<float>& there) {
    btCollisionObject obstacle;
    obstacle.setCollisionShape(&shape);
    obstacle.setWorldTransform(at(there));
    btCollisionWorld::ClosestRayResultCallback closest(vector(s.a), vector(s.b));
    btCollisionWorld::rayTestSingle(at(s.a), at(s.b), &obstacle, &shape, at(there), closest);
    return closest.hasHit();
  }

  static Motion first_contact(btConvexShape& moving, const Point3<float>& start, const Vector3<float>& velocity,
                              btConvexShape& resting, const Point3<float>& there) {
    const auto end = exactly::moved(start, velocity);
    if (!end) return std::nullopt;
    btCollisionObject obstacle;
    obstacle.setCollisionShape(&resting);
    obstacle.setWorldTransform(at(there));
    btCollisionWorld::ClosestConvexResultCallback closest(btVector3(0, 0, 0), btVector3(0, 0, 0));
    btCollisionWorld::objectQuerySingle(&moving, at(start), at(*end), &obstacle, &resting, at(there), closest, 0);
    if (!closest.hasHit()) return FirstContact<float>{HitRelation::never, {}};
    return FirstContact<float>{HitRelation::hit, closest.m_closestHitFraction};
  }
};

TOUCHSTONE_ENGINE_MAIN(Bullet)
