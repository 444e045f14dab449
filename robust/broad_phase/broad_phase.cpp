// SPDX-License-Identifier: Apache-2.0
#include "robust/broad_phase/broad_phase.h"

#include "geometry/validation_of_commands.h"
#include "robust/structures/swept_boxes.h"

namespace touchstone::robust {

Replies broad_phase(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands) {
  validation::validate_program(boxes, commands);
  return replies(SweptBoxes{}, boxes, commands);
}

}  // namespace touchstone::robust
