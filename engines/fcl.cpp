// SPDX-License-Identifier: Apache-2.0
// FCL as peer: its narrow phase over doubles with libccd, and continuous collision by conservative advancement.
#include <fcl/fcl.h>
#include <touchstone/program/engine_main.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "exactly.h"
#include "surfaces.h"

using namespace touchstone;

/// What it says of touching is not documented; nor is a tolerance of its answers as a length. Boxes that it cannot hold
/// exactly by center and size are left out, and motions whose end is not exact.
struct Fcl {
  static constexpr const char* name = "FCL " FCL_VERSION " with libccd";

  using Shape = std::shared_ptr<fcl::CollisionGeometryd>;

  std::optional<bool> sphere_sphere(const Sphere3d& a, const Sphere3d& b) {
    return meet(ball(a), at(a.center), ball(b), at(b.center));
  }
  std::optional<bool> sphere_aabb(const Sphere3d& sphere, const Aabb3d& aabb) {
    const auto box = exactly::box(aabb);
    if (!box) return std::nullopt;
    return meet(ball(sphere), at(sphere.center), solid(*box), at(box->center));
  }
  std::optional<bool> aabb_aabb(const Aabb3d& first, const Aabb3d& second) {
    const auto a = exactly::box(first), b = exactly::box(second);
    if (!a || !b) return std::nullopt;
    return meet(solid(*a), at(a->center), solid(*b), at(b->center));
  }

  /// As boxes if both are upright, else as convex solids of eight corners.
  std::optional<bool> obb_obb(const Obb3d& first, const Obb3d& second) {
    const auto a = exactly::upright(first), b = exactly::upright(second);
    if (a && b) return meet(solid(*a), at(a->center), solid(*b), at(b->center));
    const auto p = exactly::corners(first), q = exactly::corners(second);
    if (!p || !q) return std::nullopt;
    return meet(convex(*p, sides), at({0, 0, 0}), convex(*q, sides), at({0, 0, 0}));
  }

  std::optional<FirstContact<double>> swept_sphere_sphere(const Sphere3d& a, const Sphere3d& b,
                                                          const Vector3d& velocity_a, const Vector3d& velocity_b) {
    const auto end_a = exactly::moved(a.center, velocity_a), end_b = exactly::moved(b.center, velocity_b);
    if (!end_a || !end_b) return std::nullopt;
    return first_contact(ball(a), at(a.center), at(*end_a), ball(b), at(b.center), at(*end_b));
  }
  std::optional<FirstContact<double>> swept_aabb_aabb(const Aabb3d& first, const Aabb3d& second,
                                                      const Vector3d& velocity) {
    const auto a = exactly::box(first), b = exactly::box(second);
    if (!a || !b) return std::nullopt;
    const auto end = exactly::moved(a->center, velocity);
    if (!end) return std::nullopt;
    return first_contact(solid(*a), at(a->center), at(*end), solid(*b), at(b->center), at(b->center));
  }
  FirstContact<double> swept_convex_polyhedra(const Meshd& a, const Meshd& b, const Vector3d& velocity) {
    const fcl::Transform3d origin = at({0, 0, 0}), end = at({velocity.x, velocity.y, velocity.z});
    return first_contact(convex(a.vertices, a.faces), origin, end, convex(b.vertices, b.faces), origin, origin);
  }

  /// By its GJK; of solids that meet it says -1. Of many pairs of nearest points it promises no particular one: points
  /// are left out.
  ConvexDistance<double> convex_distance(const Meshd& a, const Meshd& b) {
    const fcl::CollisionObjectd first(convex(a.vertices, a.faces)), second(convex(b.vertices, b.faces));
    fcl::DistanceResultd result;
    const double distance = fcl::distance(&first, &second, fcl::DistanceRequestd(/*nearest points*/ true), result);
    if (distance <= 0) return {ConvexRelation::meeting, {}, {}, 0, 0};
    return {ConvexRelation::apart, {}, {}, distance * distance, distance};
  }
  bool sphere_triangle(const Sphere3d& sphere, const Triangle3d& t) {
    return meet(ball(sphere), at(sphere.center), soup({t.a, t.b, t.c}), at({0, 0, 0}));
  }
  /// Capsules of FCL lie along z; others need a rotation, which it cannot hold exactly.
  std::optional<bool> sphere_capsule(const Sphere3d& sphere, const Capsule3d& capsule) {
    const auto middle = upright(capsule);
    if (!middle) return std::nullopt;
    return meet(ball(sphere), at(sphere.center), middle->second, at(middle->first));
  }
  std::optional<bool> capsule_capsule(const Capsule3d& a, const Capsule3d& b) {
    const auto first = upright(a), second = upright(b);
    if (!first || !second) return std::nullopt;
    return meet(first->second, at(first->first), second->second, at(second->first));
  }

  /// As meshes of one triangle.
  bool triangle_triangle(const Triangle3d& a, const Triangle3d& b) {
    return meet(soup({a.a, a.b, a.c}), at({0, 0, 0}), soup({b.a, b.b, b.c}), at({0, 0, 0}));
  }
  /// Its meshes are surfaces.
  std::optional<bool> polyhedron_polyhedron(const Meshd& a, const Meshd& b) {
    if (!surfaces::decide(a, b)) return std::nullopt;
    return meet(surface(a), at({0, 0, 0}), surface(b), at({0, 0, 0}));
  }

 private:
  /// Triangles of corners(), which need not be counter-clockwise: no function that is called here reads the faces.
  inline static const std::vector<Face> sides{{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                                              {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};

  static fcl::Transform3d at(const Point3d& p) {
    fcl::Transform3d there = fcl::Transform3d::Identity();
    there.translation() = fcl::Vector3d(p.x, p.y, p.z);
    return there;
  }
  static Shape ball(const Sphere3d& sphere) { return std::make_shared<fcl::Sphered>(sphere.radius); }
  static Shape solid(const exactly::Box<double>& box) {
    return std::make_shared<fcl::Boxd>(2 * box.half.x, 2 * box.half.y, 2 * box.half.z);
  }
  static Shape convex(const std::vector<Point3d>& points, const std::vector<Face>& triangles) {
    auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
    for (const Point3d& p : points) vertices->emplace_back(p.x, p.y, p.z);
    auto faces = std::make_shared<std::vector<int>>();
    for (const Face& face : triangles)
      faces->insert(faces->end(), {3, static_cast<int>(face.a), static_cast<int>(face.b), static_cast<int>(face.c)});
    return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(triangles.size()), faces);
  }

  static std::optional<std::pair<Point3d, Shape>> upright(const Capsule3d& capsule) {
    const auto& [a, b] = capsule.segment;
    if (a.x != b.x || a.y != b.y) return std::nullopt;
    const auto along = exactly::middle_and_half(std::min(a.z, b.z), std::max(a.z, b.z));
    if (!along) return std::nullopt;
    return std::pair<Point3d, Shape>{{a.x, a.y, along->first},
                                     std::make_shared<fcl::Capsuled>(capsule.radius, 2 * along->second)};
  }
  static Shape soup(const std::array<Point3d, 3>& corners) {
    return surface({{corners.begin(), corners.end()}, {{0, 1, 2}}});
  }
  static Shape surface(const Meshd& of) {
    const auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
    const auto corner = [&of](Index k) { return fcl::Vector3d(of.vertices[k].x, of.vertices[k].y, of.vertices[k].z); };
    mesh->beginModel();
    for (const Face& face : of.faces) mesh->addTriangle(corner(face.a), corner(face.b), corner(face.c));
    mesh->endModel();
    return mesh;
  }

  static bool meet(const Shape& a, const fcl::Transform3d& at_a, const Shape& b, const fcl::Transform3d& at_b) {
    const fcl::CollisionObjectd first(a, at_a), second(b, at_b);
    fcl::CollisionResultd result;
    return fcl::collide(&first, &second, fcl::CollisionRequestd(), result) > 0;
  }

  static FirstContact<double> first_contact(const Shape& a, const fcl::Transform3d& start_a,
                                            const fcl::Transform3d& end_a, const Shape& b,
                                            const fcl::Transform3d& start_b, const fcl::Transform3d& end_b) {
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    fcl::ContinuousCollisionResultd result;
    const double t = fcl::continuousCollide(a.get(), start_a, end_a, b.get(), start_b, end_b, request, result);
    if (!result.is_collide) return {HitRelation::never, {}};
    return {HitRelation::hit, t};
  }
};

TOUCHSTONE_ENGINE_MAIN(Fcl)
