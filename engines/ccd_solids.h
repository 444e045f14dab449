// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ccd/ccd.h>

#include <cmath>
#include <optional>

#include "depth.h"

/// libccd as peer: convex solids by the functions that it is given of them.
namespace touchstone::ccd_solids {

static_assert(sizeof(ccd_real_t) == sizeof(double));

struct Round {
  const Meshd* core;
  double radius;
};

/// Returns the "furthest point from object in specified direction".
inline void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  const auto& [core, radius] = *static_cast<const Round*>(object);
  double most = -INFINITY;
  for (const Point3d& p : core->vertices) {
    ccd_vec3_t vertex;
    ccdVec3Set(&vertex, p.x, p.y, p.z);
    const double height = ccdVec3Dot(&vertex, direction);
    if (height > most) most = height, ccdVec3Copy(farthest, &vertex);
  }
  const double length = std::sqrt(ccdVec3Len2(direction));
  if (radius == 0 || length == 0) return;
  ccd_vec3_t beyond = *direction;
  ccdVec3Scale(&beyond, radius / length);
  ccdVec3Add(farthest, &beyond);
}
/// Returns the "geometric center (some point near center)": the mean of the vertices.
inline void center(const void* object, ccd_vec3_t* middle) {
  const Meshd& core = *static_cast<const Round*>(object)->core;
  ccdVec3Set(middle, 0, 0, 0);
  for (const Point3d& p : core.vertices) {
    ccd_vec3_t vertex;
    ccdVec3Set(&vertex, p.x, p.y, p.z);
    ccdVec3Add(middle, &vertex);
  }
  ccdVec3Scale(middle, 1 / static_cast<double>(core.vertices.size()));
}

/// Its functions move the second solid: "if obj2 is translated by distance depth in direction dir objects will have
/// touching contact". With its tolerances of 1e-4, and 100 iterations, as its README has them.
template <class Function>
std::optional<Penetration<double>> penetration(const Function& function, const Meshd& a, const Meshd& b,
                                               double radius_a, double radius_b) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = center;
  ccd.max_iterations = 100;
  const Round first{&a, radius_a}, second{&b, radius_b};
  ccd_real_t deep = 0;
  ccd_vec3_t way{{0, 0, 0}}, position;
  const int failed = function(&first, &second, &ccd, &deep, &way, &position);
  if (failed == -2) throw std::runtime_error("out of memory");
  if (failed != 0) return depth::apart(a, b, radius_a, radius_b);
  return depth::answer(a, b, radius_a, radius_b, deep, Vector3d{-way.v[0], -way.v[1], -way.v[2]});
}

}  // namespace touchstone::ccd_solids
