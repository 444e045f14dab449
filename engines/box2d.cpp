// SPDX-License-Identifier: Apache-2.0
// Box2D as peer, in single precision: circles, boxes of the broad phase, and one contact of two circles.
#include <box2d/box2d.h>
#include <touchstone/program/engine_main.h>

#include "exactly.h"
#include "one_hit.h"

using namespace touchstone;

/// What it says of touching is not documented. These shapes have no skin (box2d_polygons.cpp has those that do).
struct Box2d {
  static constexpr const char* name = "Box2D 2.4.1 (circles, boxes, contacts)";
  using number = float;

  bool sphere_sphere(const Circle2<float>& a, const Circle2<float>& b) {
    b2Manifold manifold;
    const b2CircleShape first = circle(a.radius), second = circle(b.radius);
    b2CollideCircles(&manifold, &first, at(a.center), &second, at(b.center));
    return manifold.pointCount > 0;
  }
  bool aabb_aabb(const Aabb2<float>& a, const Aabb2<float>& b) {
    return b2TestOverlap(b2AABB{vector(a.min), vector(a.max)}, b2AABB{vector(b.min), vector(b.max)});
  }

  /// Rays that start in a disc do not hit, by its documentation. It has no word of those that start in a box.
  std::optional<bool> segment_sphere(const Segment2<float>& s, const Circle2<float>& disc) {
    const b2CircleShape shape = circle(disc.radius);
    if (shape.TestPoint(at(disc.center), vector(s.a))) return std::nullopt;
    b2RayCastOutput hit;
    return shape.RayCast(&hit, {vector(s.a), vector(s.b), 1}, at(disc.center), 0);
  }
  bool segment_aabb(const Segment2<float>& s, const Aabb2<float>& box) {
    b2RayCastOutput hit;
    return b2AABB{vector(box.min), vector(box.max)}.RayCast(&hit, {vector(s.a), vector(s.b), 1});
  }

  std::optional<Velocities<float>> restitution_collision(const Masses<float>& masses, const Velocities<float>& before,
                                                         const Vector3<float>& normal, float e) {
    return bounced({masses.first, masses.second}, before, normal, e);
  }
  std::optional<Velocities<float>> elastic_collision(const Masses<float>& masses, const Velocities<float>& before,
                                                     const Vector3<float>& normal) {
    return restitution_collision(masses, before, normal, 1);
  }
  /// The second circle is static. Restitution is documented from 0 to 1.
  std::optional<Vector3<float>> damped_reflection(const Vector3<float>& v, const Vector3<float>& normal, float k) {
    if (k < 0 || k > 1) return std::nullopt;
    const auto both = bounced({1, 0}, {v, {0, 0, 0}}, normal, k);
    if (!both) return std::nullopt;
    return both->first;
  }
  std::optional<Vector3<float>> reflect_plane(const Vector3<float>& v, const Vector3<float>& normal) {
    return damped_reflection(v, normal, 1);
  }

 private:
  static constexpr float step = 1.0F / 1024;

  static b2Vec2 vector(const Point2<float>& p) { return {p.x, p.y}; }
  static b2Transform at(const Point2<float>& p) { return b2Transform(vector(p), b2Rot(0)); }
  static b2CircleShape circle(float radius) {
    b2CircleShape shape;
    shape.m_radius = radius;
    return shape;
  }
  /// Documented: a body moves b2_maxTranslation a step at most.
  static bool slow(const Vector3<float>& v) { return step * std::hypot(v.x, v.y) <= b2_maxTranslation; }

  static b2Body* body(b2World& world, float mass, const b2Vec2& where, const Vector3<float>& v, float radius, float e) {
    b2BodyDef made;
    made.type = mass > 0 ? b2_dynamicBody : b2_staticBody;
    made.position = where;
    made.linearVelocity = b2Vec2(v.x, v.y);
    b2Body* body = world.CreateBody(&made);
    const b2CircleShape shape = circle(radius);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1;
    fixture.friction = 0;
    fixture.restitution = e;
    fixture.restitutionThreshold = 0;
    body->CreateFixture(&fixture);
    const b2MassData data{mass, b2Vec2(0, 0), mass * radius * radius / 2};
    if (mass > 0) body->SetMassData(&data);
    return body;
  }

  static std::optional<Velocities<float>> bounced(const Masses<float>& masses, const Velocities<float>& before,
                                                  const Vector3<float>& normal, float e) {
    const bool planar = before.first.z == 0 && before.second.z == 0 && normal.z == 0;
    if (!planar || !slow(before.first) || !slow(before.second)) return std::nullopt;
    const auto hit = exactly::hit(before, normal);
    if (!hit) return std::nullopt;
    b2World world(b2Vec2(0, 0));
    world.SetAllowSleeping(false);
    world.SetContinuousPhysics(false);
    const float radius = hit->distance / 2;
    b2Body* a = body(world, masses.first, b2Vec2(0, 0), before.first, radius, e);
    b2Body* b = body(world, masses.second, b2Vec2(hit->between.x, hit->between.y), before.second, radius, e);
    world.Step(step, 8, 3);
    return Velocities<float>{back(a->GetLinearVelocity()), back(b->GetLinearVelocity())};
  }
  static Vector3<float> back(const b2Vec2& v) { return {v.x, v.y, 0}; }
};

TOUCHSTONE_ENGINE_MAIN(Box2d)
