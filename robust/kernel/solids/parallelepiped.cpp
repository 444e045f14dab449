// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/parallelepiped.h"

#include "geometry/validation.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust::kernel {

void validate_obb(const std::string& field, const Obb3d& box) {
  if (!valid(box)) validation::validate(field, box);
  const auto& [u, v, w] = box.half_axes;
  const Point3d o{0, 0, 0}, a = {u.x, u.y, u.z}, b = {v.x, v.y, v.z}, c = {w.x, w.y, w.z};
  if (filters::FacePlane<double>(o, a, b).side(c) != filters::Sign::unknown) return;
  if (in_turn<SideOfFace, Stage::lattice, Stage::exact>(o, a, b, c).answer == 0)
    validation::refuse(field, Obb3d::independent);
}

}  // namespace touchstone::robust::kernel
