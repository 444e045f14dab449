// SPDX-License-Identifier: Apache-2.0
#include "simulate/world/near_pairs.h"

#include <algorithm>

namespace touchstone::simulate {

std::vector<std::pair<std::size_t, std::size_t>> near_pairs(const std::vector<Aabb3d>& boxes) {
  std::vector<std::size_t> order(boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return boxes[i].min.x < boxes[j].min.x; });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (auto a = order.begin(); a != order.end(); ++a) {
    for (auto b = a + 1; b != order.end() && boxes[*b].min.x <= boxes[*a].max.x; ++b) {
      const Aabb3d &one = boxes[*a], &other = boxes[*b];
      if (one.min.y <= other.max.y && other.min.y <= one.max.y && one.min.z <= other.max.z && other.min.z <= one.max.z)
        pairs.emplace_back(std::min(*a, *b), std::max(*a, *b));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace touchstone::simulate
