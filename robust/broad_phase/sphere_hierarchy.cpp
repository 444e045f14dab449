// SPDX-License-Identifier: Apache-2.0
#include "robust/broad_phase/sphere_hierarchy.h"

#include <string>

#include "geometry/validation.h"
#include "robust/structures/ball_tree.h"
#include "robust/structures/box_tree.h"

namespace touchstone::robust {

std::vector<IndexPair> sphere_hierarchy(const std::vector<Sphere3d>& spheres) { return BallTree(spheres).pairs(); }

std::vector<IndexPair> sphere_hierarchy(const std::vector<Aabb3d>& boxes) {
  validation::validate_numbers("boxes", boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) validation::validate("boxes[" + std::to_string(i) + "]", boxes[i]);
  BoxTree tree;
  for (const Aabb3d& box : boxes) tree.insert(box);
  return tree.pairs();
}

}  // namespace touchstone::robust
