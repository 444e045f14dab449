// SPDX-License-Identifier: Apache-2.0
#include "robust/broad_phase/bounding_volume_hierarchy.h"

#include "robust/structures/box_tree.h"
#include "robust/structures/valid_program.h"

namespace touchstone::robust {

Replies bounding_volume_hierarchy(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands) {
  structures::validate_program(boxes, commands);
  return replies(BoxTree{}, boxes, commands);
}

}  // namespace touchstone::robust
