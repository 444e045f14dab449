// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bullet/BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <bullet/btBulletDynamicsCommon.h>

#include <memory>

#include "simulated.h"

namespace simulated {

inline btVector3 vector(const Three& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

inline btScalar restitution_of_scene = 0;
inline btScalar combined(const btCollisionObject*, const btCollisionObject*) { return restitution_of_scene; }

/// Bullet in single precision. Option 2 switches its continuous detection on.
class Bullet {
 public:
  explicit Bullet(const Scene& scene)
      : timestep_(static_cast<float>(scene.timestep)),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broad_phase_, &solver_, &configuration_) {
    restitution_of_scene = static_cast<float>(scene.restitution);
    gCalculateCombinedRestitutionCallback = combined;
    world_.setGravity(vector(scene.gravity));
    world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
    for (const Body& body : scene.bodies) add(body, scene.continuous);
    for (const Wall& wall : scene.walls) add(wall, scene.continuous);
  }
  ~Bullet() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  Bullet(const Bullet&) = delete;

  void step(Contacts& contacts) {
    world_.stepSimulation(timestep_, 0);
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& met = *dispatcher_.getManifoldByIndexInternal(i);
      for (int k = 0; k < met.getNumContacts(); ++k)
        if (met.getContactPoint(k).getAppliedImpulse() > 0) contacts.add(index(met.getBody0()), index(met.getBody1()));
    }
  }
  std::vector<double> body(std::size_t i) const {
    const btVector3 &p = bodies_[i]->getWorldTransform().getOrigin(), &v = bodies_[i]->getLinearVelocity();
    return {p.x(), p.y(), p.z(), v.x(), v.y(), v.z()};
  }

 private:
  static std::size_t index(const btCollisionObject* object) { return static_cast<std::size_t>(object->getUserIndex()); }

  /// Its continuous detection throws what flies at an infinite plane out of the world (docs/simulate_engines.md): there
  /// a wall is a thick box, wide enough for rooms of 50 m.
  void add(const Wall& wall, bool continuous) {
    const btVector3 normal = vector(wall.normal);
    const auto offset = static_cast<float>(wall.offset);
    if (!continuous) {
      add(std::make_unique<btStaticPlaneShape>(normal, -offset), 0, {0, 0, 0}, {0, 0, 0});
      return;
    }
    constexpr float thick = 4, wide = 64;
    add(std::make_unique<btBoxShape>(btVector3(wide, thick, wide)), 0, -(offset + thick) * normal, {0, 0, 0});
    bodies_.back()->getWorldTransform().setRotation(shortestArcQuat({0, 1, 0}, normal));
    world_.updateSingleAabb(bodies_.back().get());
  }
  void add(const Body& body, bool continuous) {
    std::unique_ptr<btCollisionShape> shape;
    if (body.sphere) shape = std::make_unique<btSphereShape>(static_cast<float>(body.radius));
    else shape = std::make_unique<btBoxShape>(vector(body.half_extents));
    const double least =
        body.sphere ? body.radius : *std::min_element(body.half_extents.begin(), body.half_extents.end());
    add(std::move(shape), body.fixed ? 0 : static_cast<float>(body.mass), vector(body.position), vector(body.velocity));
    if (!continuous || body.fixed) return;
    bodies_.back()->setCcdMotionThreshold(static_cast<float>(least));
    bodies_.back()->setCcdSweptSphereRadius(static_cast<float>(least / 2));
  }
  void add(std::unique_ptr<btCollisionShape> shape, btScalar mass, const btVector3& at, const btVector3& velocity) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get());
    info.m_startWorldTransform.setOrigin(at);
    info.m_friction = 0;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& made = *bodies_.back();
    made.setAngularFactor(0);
    made.setLinearVelocity(velocity);
    made.setActivationState(DISABLE_DEACTIVATION);
    made.setUserIndex(static_cast<int>(bodies_.size() - 1));
    world_.addRigidBody(&made);
    shapes_.push_back(std::move(shape));
  }

  btScalar timestep_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace simulated
