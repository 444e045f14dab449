// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/ray_mesh.h"

#include "robust/batch/isa/rows.h"
#include "robust/polyhedra/ray_mesh.h"
#include "robust/prepared/surface.h"

namespace touchstone::robust::batch {

void ray_mesh(const Rays3& rays, const Meshd& mesh, std::size_t count, std::uint8_t* answers, const Limits& limits) {
  if (count != 0) ray_mesh(rays, Surface(mesh), count, answers, limits);
}

void ray_mesh(const Rays3& rays, const Surface& mesh, std::size_t count, std::uint8_t* answers, const Limits& limits) {
  const auto decide = [&mesh](const Ray3d& ray) { return ray_mesh_relation(ray, mesh); };
  decide_each(limits, decide, count, answers, rays);
}

}  // namespace touchstone::robust::batch
