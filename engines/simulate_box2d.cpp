// SPDX-License-Identifier: Apache-2.0
// Box2D makes the steps of a scene in the plane, in single precision: touchstone simulate SCENE --engine
// .../simulate_box2d.
#include <box2d/box2d.h>

#include "simulated.h"

namespace {

constexpr float long_way = 1000;  // metres, half the length of a wall

b2Vec2 vector(const simulated::Three& v) { return {static_cast<float>(v[0]), static_cast<float>(v[1])}; }

class Box2d : b2ContactListener {
 public:
  explicit Box2d(const simulated::Scene& scene)
      : timestep_(static_cast<float>(scene.timestep)), world_(vector(scene.gravity)) {
    world_.SetContinuousPhysics(scene.continuous);
    world_.SetAllowSleeping(false);
    world_.SetContactListener(this);
    const auto restitution = static_cast<float>(scene.restitution);
    for (const simulated::Body& body : scene.bodies) {
      b2BodyDef def;
      def.type = body.fixed ? b2_staticBody : b2_dynamicBody;
      def.position = vector(body.position), def.linearVelocity = vector(body.velocity);
      def.fixedRotation = true;
      def.bullet = scene.continuous;
      b2CircleShape circle;
      circle.m_radius = static_cast<float>(body.radius);
      b2PolygonShape box;
      if (!body.sphere)
        box.SetAsBox(static_cast<float>(body.half_extents[0]), static_cast<float>(body.half_extents[1]));
      b2Body* const made = add(def, body.sphere ? static_cast<b2Shape&>(circle) : box, restitution);
      if (!body.fixed) made->SetMassData(new_mass(static_cast<float>(body.mass)));
    }
    for (const auto& [n, offset] : scene.walls) {
      const b2Vec2 normal = vector(n), along{-normal.y, normal.x}, foot = static_cast<float>(-offset) * normal;
      b2EdgeShape edge;
      edge.SetTwoSided(foot - long_way * along, foot + long_way * along);
      // A wall of space that lies along the plane has no edge here, and is never met.
      if (n[2] != 0) edge.SetTwoSided({1e6F, 1e6F}, {1e6F + 1, 1e6F});
      add(b2BodyDef{}, edge, restitution);
    }
  }

  void step(simulated::Contacts& contacts) {
    contacts_ = &contacts;
    world_.Step(timestep_, 8, 3);
  }
  std::vector<double> body(std::size_t i) const {
    const b2Vec2 p = bodies_[i]->GetPosition(), v = bodies_[i]->GetLinearVelocity();
    return {p.x, p.y, 0, v.x, v.y, 0};
  }

 private:
  static const b2MassData* new_mass(float mass) {
    static b2MassData data;
    data = {mass, {0, 0}, 0};
    return &data;
  }
  b2Body* add(b2BodyDef def, const b2Shape& shape, float restitution) {
    def.userData.pointer = bodies_.size();
    bodies_.push_back(world_.CreateBody(&def));
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1;
    fixture.friction = 0;
    fixture.restitution = restitution;
    fixture.restitutionThreshold = 0;
    bodies_.back()->CreateFixture(&fixture);
    return bodies_.back();
  }
  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
    const auto index = [](b2Fixture* fixture) {
      return static_cast<std::size_t>(fixture->GetBody()->GetUserData().pointer);
    };
    for (int k = 0; k < impulse->count; ++k)
      if (impulse->normalImpulses[k] > 0) contacts_->add(index(contact->GetFixtureA()), index(contact->GetFixtureB()));
  }

  float timestep_;
  b2World world_;
  std::vector<b2Body*> bodies_;
  simulated::Contacts* contacts_ = nullptr;
};

}  // namespace

int main() {
  return simulated::run<Box2d>(
      {{"engine", "Box2D 2.4.1"},
       {"number", "binary32"},
       {"cannot", {"particles", "stick", "penalty", "space"}},
       {"thresholds",
        {"0.01 m of skin on boxes and walls (polygon radius)", "0.005 m of depth are left (linear slop)",
         "2 m a step at most (maximum translation)"}}});
}
