// SPDX-License-Identifier: Apache-2.0
// ODE as peer, in double precision: geometries, and one contact.
#include <ode/ode.h>
#include <touchstone/program/engine_main.h>

#include <algorithm>

#include "exactly.h"
#include "one_hit.h"

using namespace touchstone;

/// What it says of touching is not documented. Balls of radius 0 and boxes without extent have no size for it
/// and are left out; so are boxes that it cannot hold exactly.
struct Ode {
  static constexpr const char* name = "ODE 0.16.2";

  Ode() { dInitODE2(0); }
  ~Ode() { dCloseODE(); }
  Ode(const Ode&) = delete;

  using Box = std::optional<exactly::Box<double>>;

  std::optional<bool> sphere_sphere(const Sphere3d& a, const Sphere3d& b) {
    if (a.radius == 0 || b.radius == 0) return std::nullopt;
    return meet(ball(a), a.center, ball(b), b.center);
  }
  std::optional<bool> sphere_aabb(const Sphere3d& sphere, const Aabb3d& aabb) {
    const Box box = exactly::box(aabb);
    if (!has_size(box) || sphere.radius == 0) return std::nullopt;
    return meet(ball(sphere), sphere.center, solid(*box), box->center);
  }
  std::optional<bool> aabb_aabb(const Aabb3d& a, const Aabb3d& b) { return meet(exactly::box(a), exactly::box(b)); }
  std::optional<bool> obb_obb(const Obb3d& a, const Obb3d& b) { return meet(exactly::upright(a), exactly::upright(b)); }

  std::optional<bool> aabb_obb(const Aabb3d& a, const Obb3d& b) { return meet(exactly::box(a), exactly::upright(b)); }
  std::optional<bool> sphere_obb(const Sphere3d& sphere, const Obb3d& obb) {
    const Box box = exactly::upright(obb);
    if (!has_size(box) || sphere.radius == 0) return std::nullopt;
    return meet(ball(sphere), sphere.center, solid(*box), box->center);
  }
  std::optional<bool> sphere_capsule(const Sphere3d& sphere, const Capsule3d& capsule) {
    const auto middle = upright(capsule);
    if (!middle || sphere.radius == 0) return std::nullopt;
    return meet(ball(sphere), sphere.center, solid(*middle), middle->center);
  }
  std::optional<bool> capsule_capsule(const Capsule3d& a, const Capsule3d& b) {
    const auto first = upright(a), second = upright(b);
    if (!first || !second) return std::nullopt;
    return meet(solid(*first), first->center, solid(*second), second->center);
  }
  std::optional<bool> capsule_aabb(const Capsule3d& capsule, const Aabb3d& aabb) {
    return meet(upright(capsule), exactly::box(aabb));
  }
  std::optional<bool> capsule_obb(const Capsule3d& capsule, const Obb3d& obb) {
    return meet(upright(capsule), exactly::upright(obb));
  }
  /// Its planes have a half-space behind them, and normals of length 1: those across an axis are exact.
  std::optional<bool> capsule_plane(const Capsule3d& capsule, const Plane<double>& plane) {
    const auto middle = upright(capsule);
    const auto unit = exactly::across_axis(plane);
    if (!middle || !unit) return std::nullopt;
    return meet(solid(*middle), middle->center, *unit);
  }
  std::optional<bool> obb_plane(const Obb3d& obb, const Plane<double>& plane) {
    const Box box = exactly::upright(obb);
    const auto unit = exactly::across_axis(plane);
    if (!has_size(box) || !unit) return std::nullopt;
    return meet(solid(*box), box->center, *unit);
  }

  /// Rays of ODE have a length, and are made of a direction of length 1: only axes are asked, with the greatest length
  /// whose square is finite.
  std::optional<bool> ray_sphere(const Ray3d& ray, const Sphere3d& sphere) {
    if (sphere.radius == 0) return std::nullopt;
    return cast(ray, ball(sphere), sphere.center);
  }
  std::optional<bool> ray_aabb(const Ray3d& ray, const Aabb3d& aabb) {
    const Box box = exactly::box(aabb);
    if (!has_size(box)) return std::nullopt;
    return cast(ray, solid(*box), box->center);
  }
  std::optional<bool> ray_obb(const Ray3d& ray, const Obb3d& obb) {
    const Box box = exactly::upright(obb);
    if (!has_size(box)) return std::nullopt;
    return cast(ray, solid(*box), box->center);
  }
  std::optional<bool> ray_capsule(const Ray3d& ray, const Capsule3d& capsule) {
    const auto middle = upright(capsule);
    if (!middle) return std::nullopt;
    return cast(ray, solid(*middle), middle->center);
  }

  /// dContactBounce with bounce_vel 0 and no softness: the contact is between the balls, where they touch.
  std::optional<Velocities<double>> restitution_collision(const Massesd& masses, const Velocitiesd& velocities,
                                                          const Vector3d& normal, double e) {
    const auto hit = exactly::hit(velocities, normal);
    if (!hit) return std::nullopt;
    const dWorldID world = dWorldCreate();
    dWorldSetCFM(world, 0);
    const dBodyID a = body(world, masses.first, *hit, velocities.first),
                  b = body(world, masses.second, *hit, velocities.second);
    dBodySetPosition(b, hit->between.x, hit->between.y, hit->between.z);
    step(world, a, b, *hit, e);
    const Velocities<double> after{velocity(a), velocity(b)};
    dWorldDestroy(world);
    return after;
  }
  std::optional<Velocities<double>> elastic_collision(const Massesd& masses, const Velocitiesd& velocities,
                                                      const Vector3d& normal) {
    return restitution_collision(masses, velocities, normal, 1);
  }

  /// The same with the environment for the second body; bounce is documented from 0 to 1.
  std::optional<Vector3d> damped_reflection(const Vector3d& v, const Vector3d& normal, double k) {
    const auto hit = exactly::hit(Velocitiesd{v, {0, 0, 0}}, normal);
    if (!hit || k < 0 || k > 1) return std::nullopt;
    const dWorldID world = dWorldCreate();
    dWorldSetCFM(world, 0);
    const dBodyID a = body(world, 1, *hit, v);
    step(world, a, nullptr, *hit, k);
    const Vector3d after = velocity(a);
    dWorldDestroy(world);
    return after;
  }
  std::optional<Vector3d> reflect_plane(const Vector3d& v, const Vector3d& normal) {
    return damped_reflection(v, normal, 1);
  }

 private:
  /// Its capsules lie along z, have a length and a radius: others are left out.
  struct Upright {
    Point3d center;
    double length, radius;
  };
  static std::optional<Upright> upright(const Capsule3d& capsule) {
    const auto& [a, b] = capsule.segment;
    const auto along = exactly::middle_and_half(std::min(a.z, b.z), std::max(a.z, b.z));
    if (a.x != b.x || a.y != b.y || !along || along->second == 0 || capsule.radius == 0) return std::nullopt;
    return Upright{{a.x, a.y, along->first}, 2 * along->second, capsule.radius};
  }
  static dGeomID solid(const Upright& capsule) { return dCreateCapsule(nullptr, capsule.radius, capsule.length); }

  static dGeomID ball(const Sphere3d& sphere) { return dCreateSphere(nullptr, sphere.radius); }
  static dGeomID solid(const exactly::Box<double>& box) {
    return dCreateBox(nullptr, 2 * box.half.x, 2 * box.half.y, 2 * box.half.z);
  }
  static bool has_size(const Box& box) { return box && box->half.x > 0 && box->half.y > 0 && box->half.z > 0; }

  static std::optional<bool> cast(const Ray3d& ray, dGeomID solid, const Point3d& there) {
    const auto& [p, v] = ray;
    if ((v.x != 0) + (v.y != 0) + (v.z != 0) != 1) {
      dGeomDestroy(solid);
      return std::nullopt;
    }
    const dGeomID line = dCreateRay(nullptr, 0x1p500);
    dGeomRaySet(line, p.x, p.y, p.z, v.x, v.y, v.z);
    dGeomSetPosition(solid, there.x, there.y, there.z);
    dContactGeom contact;
    const int found = dCollide(line, solid, 1, &contact, sizeof(dContactGeom));
    dGeomDestroy(line);
    dGeomDestroy(solid);
    return found > 0;
  }
  static bool meet(dGeomID a, const Point3d& at_a, dGeomID b, const Point3d& at_b) {
    dGeomSetPosition(a, at_a.x, at_a.y, at_a.z);
    dGeomSetPosition(b, at_b.x, at_b.y, at_b.z);
    dContactGeom contacts[8];
    const int found = dCollide(a, b, 8, contacts, sizeof(dContactGeom));
    dGeomDestroy(a);
    dGeomDestroy(b);
    return found > 0;
  }
  static bool meet(dGeomID a, const Point3d& at_a, const Plane<double>& plane) {
    const auto& [n, offset] = plane;
    const dGeomID b = dCreatePlane(nullptr, n.x, n.y, n.z, -offset);
    dGeomSetPosition(a, at_a.x, at_a.y, at_a.z);
    dContactGeom contacts[8];
    const int found = dCollide(a, b, 8, contacts, sizeof(dContactGeom));
    dGeomDestroy(a);
    dGeomDestroy(b);
    return found > 0;
  }
  static std::optional<bool> meet(const std::optional<Upright>& capsule, const Box& box) {
    if (!capsule || !has_size(box)) return std::nullopt;
    return meet(solid(*capsule), capsule->center, solid(*box), box->center);
  }
  static std::optional<bool> meet(const Box& a, const Box& b) {
    if (!has_size(a) || !has_size(b)) return std::nullopt;
    return meet(solid(*a), a->center, solid(*b), b->center);
  }

  static dBodyID body(dWorldID world, double mass, const exactly::Hit<double>& hit, const Vector3d& v) {
    const dBodyID made = dBodyCreate(world);
    dMass ball;
    dMassSetSphereTotal(&ball, mass, hit.distance / 2);
    dBodySetMass(made, &ball);
    dBodySetLinearVel(made, v.x, v.y, v.z);
    return made;
  }
  static Vector3d velocity(dBodyID body) {
    const dReal* v = dBodyGetLinearVel(body);
    return {v[0], v[1], v[2]};
  }
  static void step(dWorldID world, dBodyID a, dBodyID b, const exactly::Hit<double>& hit, double e) {
    dContact contact{};
    contact.surface.mode = dContactBounce;
    contact.surface.bounce = e;
    const double across[3] = {hit.between.x, hit.between.y, hit.between.z};
    for (int k = 0; k < 3; ++k) {
      contact.geom.normal[k] = -across[k] / hit.distance;  // into the first body
      contact.geom.pos[k] = across[k] / 2;
    }
    const dJointID joint = dJointCreateContact(world, nullptr, &contact);
    dJointAttach(joint, a, b);
    dWorldStep(world, 1.0 / 64);
  }
};

TOUCHSTONE_ENGINE_MAIN(Ode)
