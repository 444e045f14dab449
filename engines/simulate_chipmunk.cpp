// SPDX-License-Identifier: Apache-2.0
// Chipmunk makes the steps of a scene in the plane, in double precision: touchstone simulate SCENE --engine
// .../simulate_chipmunk.
#include <chipmunk/chipmunk.h>

#include "simulated.h"

namespace {

constexpr double thick = 64, long_way = 1000;  // metres of a wall: its radius and half its length

cpVect vector(const simulated::Three& v) { return cpv(v[0], v[1]); }

class Chipmunk {
 public:
  explicit Chipmunk(const simulated::Scene& scene)
      : timestep_(scene.timestep), restitution_(scene.restitution), space_(cpSpaceNew()) {
    cpSpaceSetGravity(space_, vector(scene.gravity));
    cpSpaceSetCollisionSlop(space_, 0);
    cpCollisionHandler* const handler = cpSpaceAddDefaultCollisionHandler(space_);
    handler->userData = this;
    handler->preSolveFunc = [](cpArbiter* arbiter, cpSpace*, void* self) -> cpBool {
      cpArbiterSetRestitution(arbiter, static_cast<Chipmunk*>(self)->restitution_);
      return cpTrue;
    };
    handler->postSolveFunc = [](cpArbiter* arbiter, cpSpace*, void* self) {
      const cpVect j = cpArbiterTotalImpulse(arbiter);
      cpShape *a, *b;
      cpArbiterGetShapes(arbiter, &a, &b);
      if (j.x != 0 || j.y != 0) static_cast<Chipmunk*>(self)->contacts_->add(index(a), index(b));
    };
    for (const simulated::Body& body : scene.bodies) {
      cpBody* const made = body.fixed ? cpBodyNewStatic() : cpBodyNew(body.mass, INFINITY);
      cpSpaceAddBody(space_, made);
      cpBodySetPosition(made, vector(body.position));
      if (!body.fixed) cpBodySetVelocity(made, vector(body.velocity));
      const auto& [x, y, z] = body.half_extents;
      add(body.sphere ? cpCircleShapeNew(made, body.radius, cpvzero) : cpBoxShapeNew(made, 2 * x, 2 * y, 0), made);
    }
    for (const auto& [n, offset] : scene.walls) {
      cpBody* const still = cpSpaceGetStaticBody(space_);
      // A wall of space that lies along the plane is far away here, and is never met.
      const cpVect normal = vector(n), along = n[2] != 0 ? cpv(1, 0) : cpvperp(normal);
      const cpVect middle = n[2] != 0 ? cpv(1e6, 1e6) : cpvmult(normal, -offset - thick);
      add(cpSegmentShapeNew(still, cpvsub(middle, cpvmult(along, long_way)), cpvadd(middle, cpvmult(along, long_way)),
                            thick),
          still);
    }
  }

  void step(simulated::Contacts& contacts) {
    contacts_ = &contacts;
    cpSpaceStep(space_, timestep_);
  }
  std::vector<double> body(std::size_t i) const {
    const cpVect p = cpBodyGetPosition(bodies_[i]), v = cpBodyGetVelocity(bodies_[i]);
    return {p.x, p.y, 0, v.x, v.y, 0};
  }

 private:
  static std::size_t index(const cpShape* shape) { return reinterpret_cast<std::size_t>(cpShapeGetUserData(shape)); }
  void add(cpShape* shape, cpBody* body) {
    cpShapeSetUserData(shape, reinterpret_cast<void*>(bodies_.size()));
    cpShapeSetFriction(shape, 0);
    cpSpaceAddShape(space_, shape);
    bodies_.push_back(body);
  }

  double timestep_, restitution_;
  cpSpace* space_;
  std::vector<cpBody*> bodies_;
  simulated::Contacts* contacts_ = nullptr;
};

}  // namespace

int main() {
  return simulated::run<Chipmunk>(
      {{"engine", std::string("Chipmunk ") + cpVersionString},
       {"cannot", {"particles", "stick", "penalty", "space"}},
       {"thresholds", {"no continuous detection", "0.1 of a depth is undone in 1/60 s (bias)"}}});
}
