// SPDX-License-Identifier: Apache-2.0
#include "robust/broad_phase/broad_phase.h"

#include "robust/structures/swept_boxes.h"
#include "robust/structures/valid_program.h"

namespace touchstone::robust {

Replies broad_phase(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands) {
  structures::validate_program(boxes, commands);
  return replies(SweptBoxes{}, boxes, commands);
}

}  // namespace touchstone::robust
