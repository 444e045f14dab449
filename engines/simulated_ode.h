// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ode/ode.h>

#include <deque>

#include "simulated.h"

namespace simulated {

inline constexpr double inertia = 1e12;  // of a body that shall not turn, for each kilogram

/// ODE in double precision. `quick`: by iteration instead of exactly, as its manual advises for many bodies.
class Ode {
 public:
  explicit Ode(const Scene& scene, bool quick = false)
      : quick_(quick), timestep_(scene.timestep), restitution_(scene.restitution) {
    dInitODE2(0);
    world_ = dWorldCreate();
    space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    joints_ = dJointGroupCreate(0);
    const auto& [x, y, z] = scene.gravity;
    dWorldSetGravity(world_, x, y, z);
    dWorldSetCFM(world_, 0);
    for (const Body& body : scene.bodies) add(body);
    for (const auto& [n, offset] : scene.walls) name(dCreatePlane(space_, n[0], n[1], n[2], -offset));
  }
  ~Ode() {
    dJointGroupDestroy(joints_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    dCloseODE();
  }
  Ode(const Ode&) = delete;

  void step(Contacts& contacts) {
    met_.clear();
    dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) { static_cast<Ode*>(self)->meet(a, b); });
    if (quick_) dWorldQuickStep(world_, timestep_);
    else dWorldStep(world_, timestep_);
    for (const Met& met : met_) {
      const dReal *f = met.feedback.f1, *g = met.feedback.f2;
      if (f[0] != 0 || f[1] != 0 || f[2] != 0 || g[0] != 0 || g[1] != 0 || g[2] != 0) contacts.add(met.a, met.b);
    }
    dJointGroupEmpty(joints_);
    const dMatrix3 upright{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    for (const dBodyID body : bodies_) {
      if (body == nullptr) continue;
      dBodySetAngularVel(body, 0, 0, 0);
      dBodySetRotation(body, upright);
    }
  }
  std::vector<double> body(std::size_t i) const {
    const dReal* const p = dGeomGetPosition(geometries_[i]);
    if (bodies_[i] == nullptr) return {p[0], p[1], p[2], 0, 0, 0};
    const dReal* const v = dBodyGetLinearVel(bodies_[i]);
    return {p[0], p[1], p[2], v[0], v[1], v[2]};
  }

 private:
  struct Met {
    std::size_t a, b;
    dJointFeedback feedback;
  };

  static std::size_t index(dGeomID geometry) { return reinterpret_cast<std::size_t>(dGeomGetData(geometry)); }
  void name(dGeomID geometry) {
    dGeomSetData(geometry, reinterpret_cast<void*>(geometries_.size()));
    geometries_.push_back(geometry);
  }

  void add(const Body& body) {
    const auto& [x, y, z] = body.half_extents;
    const dGeomID geometry = body.sphere ? dCreateSphere(space_, body.radius) : dCreateBox(space_, 2 * x, 2 * y, 2 * z);
    dBodyID made = nullptr;
    if (!body.fixed) {
      made = dBodyCreate(world_);
      dMass mass;
      dMassSetParameters(&mass, body.mass, 0, 0, 0, inertia * body.mass, inertia * body.mass, inertia * body.mass, 0, 0,
                         0);
      dBodySetMass(made, &mass);
      dBodySetLinearVel(made, body.velocity[0], body.velocity[1], body.velocity[2]);
      dBodySetAutoDisableFlag(made, 0);
      dGeomSetBody(geometry, made);
    }
    dGeomSetPosition(geometry, body.position[0], body.position[1], body.position[2]);
    name(geometry);
    bodies_.push_back(made);
  }

  void meet(dGeomID a, dGeomID b) {
    const dBodyID one = dGeomGetBody(a), other = dGeomGetBody(b);
    if (one == nullptr && other == nullptr) return;
    dContactGeom found[8];
    const int count = dCollide(a, b, 8, found, sizeof found[0]);
    for (int k = 0; k < count; ++k) {
      dContact contact{};
      contact.surface.mode = dContactBounce;
      contact.surface.bounce = restitution_;
      contact.geom = found[k];
      const dJointID joint = dJointCreateContact(world_, joints_, &contact);
      met_.push_back({index(a), index(b), {}});
      dJointSetFeedback(joint, &met_.back().feedback);
      dJointAttach(joint, one, other);
    }
  }

  bool quick_;
  double timestep_, restitution_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID joints_;
  std::vector<dBodyID> bodies_;  ///< none for a fixed one
  std::vector<dGeomID> geometries_;
  std::deque<Met> met_;
};

}  // namespace simulated
