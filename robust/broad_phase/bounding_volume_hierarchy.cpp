// SPDX-License-Identifier: Apache-2.0
#include "robust/broad_phase/bounding_volume_hierarchy.h"

#include "geometry/validation_of_commands.h"
#include "robust/structures/box_tree.h"

namespace touchstone::robust {

Replies bounding_volume_hierarchy(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands) {
  validation::validate_program(boxes, commands);
  return replies(BoxTree{}, boxes, commands);
}

}  // namespace touchstone::robust
