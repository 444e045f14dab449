// SPDX-License-Identifier: Apache-2.0
#pragma once

// Bullet as peer, in single precision: shapes, and its functions of two of them.
#include <bullet/BulletCollision/CollisionShapes/btTriangleShape.h>
#include <bullet/BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <bullet/BulletCollision/Gimpact/btGImpactShape.h>
#include <bullet/btBulletDynamicsCommon.h>
#include <touchstone/geometry/capsules.h>
#include <touchstone/geometry/impacts.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "exactly.h"

namespace touchstone::bullet_shapes {

using MaybeContact = std::optional<FirstContact<float>>;

inline btVector3 vector(const Vector3<float>& v) { return {v.x, v.y, v.z}; }
inline btVector3 vector(const Point3<float>& p) { return {p.x, p.y, p.z}; }
inline Vector3<float> back(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline btTransform at(const btVector3& p) { return btTransform(btQuaternion::getIdentity(), p); }
inline btTransform at(const Point3<float>& p) { return at(vector(p)); }

/// A shape and its place.
struct Placed {
  std::unique_ptr<btCollisionShape> shape;
  Point3<float> at{0, 0, 0};
  btConvexShape& convex() const { return static_cast<btConvexShape&>(*shape); }
};
using MaybePlaced = std::optional<Placed>;

inline Placed ball(const Sphere3<float>& sphere) {
  return {std::make_unique<btSphereShape>(sphere.radius), sphere.center};
}
inline MaybePlaced solid(const std::optional<exactly::Box<float>>& box) {
  if (!box) return std::nullopt;
  return Placed{std::make_unique<btBoxShape>(vector(box->half)), box->center};
}
inline MaybePlaced solid(const Aabb3<float>& aabb) { return solid(exactly::box(aabb)); }

/// Margins of hulls and triangles lie outside: a hull with a margin is the rounded solid.
inline Placed hull(const std::vector<Point3<float>>& points, float margin = 0) {
  auto made = std::make_unique<btConvexHullShape>();
  made->setMargin(margin);
  for (const Point3<float>& p : points) made->addPoint(vector(p), false);
  made->recalcLocalAabb();
  return {std::move(made)};
}
/// As a hull of eight corners.
inline MaybePlaced eight_corners(const Obb3<float>& obb) {
  const auto corners = exactly::corners(obb);
  if (!corners) return std::nullopt;
  return hull(*corners);
}
/// As a box if it is upright, else as that.
inline MaybePlaced solid(const Obb3<float>& obb) {
  const auto box = exactly::upright(obb);
  return box ? solid(box) : eight_corners(obb);
}
inline Placed triangle(const Triangle3<float>& t) {
  auto made = std::make_unique<btTriangleShape>(vector(t.a), vector(t.b), vector(t.c));
  made->setMargin(0);
  return {std::move(made)};
}

/// Its capsules lie along an axis of coordinates, its center in the middle; others are left out.
inline MaybePlaced solid(const Capsule3<float>& capsule) {
  const auto& [a, b] = capsule.segment;
  if ((a.x != b.x) + (a.y != b.y) + (a.z != b.z) > 1) return std::nullopt;
  const auto x = exactly::middle_and_half(std::min(a.x, b.x), std::max(a.x, b.x)),
             y = exactly::middle_and_half(std::min(a.y, b.y), std::max(a.y, b.y)),
             z = exactly::middle_and_half(std::min(a.z, b.z), std::max(a.z, b.z));
  if (!x || !y || !z) return std::nullopt;
  Placed made{nullptr, {x->first, y->first, z->first}};
  if (x->second > 0) made.shape = std::make_unique<btCapsuleShapeX>(capsule.radius, 2 * x->second);
  else if (z->second > 0) made.shape = std::make_unique<btCapsuleShapeZ>(capsule.radius, 2 * z->second);
  else made.shape = std::make_unique<btCapsuleShape>(capsule.radius, 2 * y->second);
  return made;
}

/// The half-space behind the plane: n . p = d, with n of length 1, is exact across an axis.
inline MaybePlaced behind(const Plane<float>& plane) {
  const auto unit = exactly::across_axis(plane);
  if (!unit) return std::nullopt;
  return Placed{std::make_unique<btStaticPlaneShape>(vector(unit->normal), -unit->offset)};
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
  }
  /// For a moving mesh (GImpact), without its margin.
  std::unique_ptr<btGImpactMeshShape> moving() {
    auto shape = std::make_unique<btGImpactMeshShape>(triangles_.get());
    shape->setMargin(0);
    shape->updateBound();
    return shape;
  }
  /// For a mesh at rest, without its margin.
  std::unique_ptr<btBvhTriangleMeshShape> resting() {
    auto shape = std::make_unique<btBvhTriangleMeshShape>(triangles_.get(), /*quantized*/ false);
    shape->setMargin(0);
    return shape;
  }

 private:
  std::vector<Point3<float>> vertices_;
  std::vector<int> corners_;
  std::unique_ptr<btTriangleIndexVertexArray> triangles_;
};

/// The deepest contact of two shapes; none where they are farther apart than it looks.
struct Deepest : btCollisionWorld::ContactResultCallback {
  std::optional<float> distance;
  btVector3 from_b{0, 0, 0};  // normal
  const btCollisionObject* a = nullptr;
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* first, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    if (distance && *distance <= point.getDistance()) return 0;
    distance = point.getDistance();
    from_b = first->getCollisionObject() == a ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
    return 0;
  }
};

inline Deepest deepest(btCollisionShape& a, const Point3<float>& at_a, btCollisionShape& b, const Point3<float>& at_b) {
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
  Deepest found;
  found.a = &first;
  world.contactPairTest(&first, &second, found);
  return found;
}
inline Deepest deepest(const Placed& a, const Placed& b) { return deepest(*a.shape, a.at, *b.shape, b.at); }
inline std::optional<bool> meet(const MaybePlaced& a, const MaybePlaced& b) {
  if (!a || !b) return std::nullopt;
  const auto distance = deepest(*a, *b).distance;
  return distance && *distance <= 0;
}

/// Rays of Bullet end. What it answers about one that starts in the shape is not documented.
inline std::optional<bool> cast(const Segment3<float>& s, const MaybePlaced& solid) {
  if (!solid) return std::nullopt;
  btCollisionObject obstacle;
  obstacle.setCollisionShape(solid->shape.get());
  obstacle.setWorldTransform(at(solid->at));
  btCollisionWorld::ClosestRayResultCallback closest(vector(s.a), vector(s.b));
  btCollisionWorld::rayTestSingle(at(s.a), at(s.b), &obstacle, solid->shape.get(), at(solid->at), closest);
  return closest.hasHit();
}

/// a moves, b rests.
inline MaybeContact first_contact(const MaybePlaced& a, const Vector3<float>& velocity, const MaybePlaced& b) {
  if (!a || !b) return std::nullopt;
  const auto end = exactly::moved(a->at, velocity);
  if (!end) return std::nullopt;
  btCollisionObject obstacle;
  obstacle.setCollisionShape(b->shape.get());
  obstacle.setWorldTransform(at(b->at));
  btCollisionWorld::ClosestConvexResultCallback closest(btVector3(0, 0, 0), btVector3(0, 0, 0));
  btCollisionWorld::objectQuerySingle(&a->convex(), at(a->at), at(*end), &obstacle, b->shape.get(), at(b->at), closest,
                                      0);
  if (!closest.hasHit()) return FirstContact<float>{HitRelation::never, {}};
  return FirstContact<float>{HitRelation::hit, closest.m_closestHitFraction};
}

}  // namespace touchstone::bullet_shapes
