// SPDX-License-Identifier: Apache-2.0
#pragma once

// FCL as peer, in double precision: shapes at their places, and its functions of two of them.
#include <fcl/fcl.h>
#include <touchstone/geometry/capsules.h>
#include <touchstone/geometry/impacts.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "exactly.h"

namespace touchstone::fcl_shapes {

using Shape = std::shared_ptr<fcl::CollisionGeometryd>;

struct Placed {
  Shape shape;
  fcl::Transform3d at = fcl::Transform3d::Identity();
};

inline Placed placed(Shape shape, const Point3d& p) {
  Placed there{std::move(shape)};
  there.at.translation() = fcl::Vector3d(p.x, p.y, p.z);
  return there;
}

inline Placed ball(const Sphere3d& sphere) {
  return placed(std::make_shared<fcl::Sphered>(sphere.radius), sphere.center);
}
inline std::optional<Placed> solid(const std::optional<exactly::Box<double>>& box) {
  if (!box) return std::nullopt;
  return placed(std::make_shared<fcl::Boxd>(2 * box->half.x, 2 * box->half.y, 2 * box->half.z), box->center);
}
inline std::optional<Placed> solid(const Aabb3d& aabb) { return solid(exactly::box(aabb)); }

inline Placed convex(const std::vector<Point3d>& points, const std::vector<Face>& triangles) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Point3d& p : points) vertices->emplace_back(p.x, p.y, p.z);
  auto faces = std::make_shared<std::vector<int>>();
  for (const Face& face : triangles)
    faces->insert(faces->end(), {3, static_cast<int>(face.a), static_cast<int>(face.b), static_cast<int>(face.c)});
  return {std::make_shared<fcl::Convexd>(vertices, static_cast<int>(triangles.size()), faces)};
}
inline Placed convex(const Meshd& mesh) { return convex(mesh.vertices, mesh.faces); }

/// Triangles of exactly::corners(), which need not be counter-clockwise: no function that is called here reads the
/// faces.
inline const std::vector<Face> sides{{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                                     {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};

/// As a convex solid of eight corners.
inline std::optional<Placed> eight_corners(const Obb3d& obb) {
  const auto corners = exactly::corners(obb);
  if (!corners) return std::nullopt;
  return convex(*corners, sides);
}
/// As a box if it is upright, else as that.
inline std::optional<Placed> solid(const Obb3d& obb) {
  const auto box = exactly::upright(obb);
  return box ? solid(box) : eight_corners(obb);
}

/// Capsules of FCL lie along z: those along the other axes are turned by a permutation of the axes, which is exact, and
/// others are left out.
inline std::optional<Placed> solid(const Capsule3d& capsule) {
  const auto& [a, b] = capsule.segment;
  const std::array<std::pair<double, double>, 3> ends{{{a.x, b.x}, {a.y, b.y}, {a.z, b.z}}};
  const auto apart = [&ends](std::size_t k) { return ends[k].first != ends[k].second; };
  if (apart(0) + apart(1) + apart(2) > 1) return std::nullopt;
  const std::size_t along = apart(0) ? 0 : apart(1) ? 1 : 2;
  const auto middle = exactly::middle_and_half(std::min(ends[along].first, ends[along].second),
                                               std::max(ends[along].first, ends[along].second));
  if (!middle) return std::nullopt;
  Placed made = placed(std::make_shared<fcl::Capsuled>(capsule.radius, 2 * middle->second), a);
  made.at.translation()[static_cast<Eigen::Index>(along)] = middle->first;
  fcl::Matrix3d turn = fcl::Matrix3d::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    turn(static_cast<Eigen::Index>((along + 1 + k) % 3), static_cast<Eigen::Index>(k)) = 1;
  made.at.linear() = turn;
  return made;
}

/// Its planes and half-spaces have normals of length 1 and keep n . p = d: those across an axis are exact. The
/// half-space is behind the plane, as ours.
template <class Made>
std::optional<Placed> across_axis(const Plane<double>& plane) {
  const auto unit = exactly::across_axis(plane);
  if (!unit) return std::nullopt;
  const auto& [n, offset] = *unit;
  return Placed{std::make_shared<Made>(fcl::Vector3d(n.x, n.y, n.z), -offset)};
}

inline Placed surface(const Meshd& of) {
  const auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  const auto corner = [&of](Index k) { return fcl::Vector3d(of.vertices[k].x, of.vertices[k].y, of.vertices[k].z); };
  mesh->beginModel();
  for (const Face& face : of.faces) mesh->addTriangle(corner(face.a), corner(face.b), corner(face.c));
  mesh->endModel();
  return {mesh};
}
inline Placed surface(const Triangle3d& t) { return surface(Meshd{{t.a, t.b, t.c}, {{0, 1, 2}}}); }

inline bool meet(const Placed& a, const Placed& b) {
  const fcl::CollisionObjectd first(a.shape, a.at), second(b.shape, b.at);
  fcl::CollisionResultd result;
  return fcl::collide(&first, &second, fcl::CollisionRequestd(), result) > 0;
}
inline std::optional<bool> meet(const std::optional<Placed>& a, const std::optional<Placed>& b) {
  if (!a || !b) return std::nullopt;
  return meet(*a, *b);
}

/// By conservative advancement. Its default, the naive solver, asks ten moments alone.
inline FirstContact<double> first_contact(const Placed& a, const fcl::Transform3d& end_a, const Placed& b,
                                          const fcl::Transform3d& end_b) {
  fcl::ContinuousCollisionRequestd request;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  fcl::ContinuousCollisionResultd result;
  const double t = fcl::continuousCollide(a.shape.get(), a.at, end_a, b.shape.get(), b.at, end_b, request, result);
  if (!result.is_collide) return {HitRelation::never, {}};
  return {HitRelation::hit, t};
}
inline std::optional<fcl::Transform3d> end_of(const Placed& start, const Vector3d& velocity) {
  const fcl::Vector3d& p = start.at.translation();
  const auto end = exactly::moved(Point3d{p[0], p[1], p[2]}, velocity);
  if (!end) return std::nullopt;
  fcl::Transform3d there = start.at;
  there.translation() = fcl::Vector3d(end->x, end->y, end->z);
  return there;
}
/// a moves, b rests: where the end of the motion is exact.
inline std::optional<FirstContact<double>> first_contact(const std::optional<Placed>& a, const Vector3d& velocity,
                                                         const std::optional<Placed>& b) {
  if (!a || !b) return std::nullopt;
  const auto end = end_of(*a, velocity);
  if (!end) return std::nullopt;
  return first_contact(*a, *end, *b, b->at);
}

}  // namespace touchstone::fcl_shapes
