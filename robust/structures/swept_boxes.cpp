// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/swept_boxes.h"

#include <algorithm>

#include "geometry/validation.h"
#include "robust/structures/sort_and_sweep.h"

namespace touchstone::robust {

std::size_t SweptBoxes::place_of(Index body) const {
  const auto found = std::lower_bound(bodies_.begin(), bodies_.end(), body);
  if (found == bodies_.end() || *found != body) throw InvalidInput("body", "index of a body that is there");
  return static_cast<std::size_t>(found - bodies_.begin());
}

Index SweptBoxes::insert(const Aabb3d& box) {
  validation::validate("box", box);
  boxes_.push_back(box);
  bodies_.push_back(next_);
  return next_++;
}

void SweptBoxes::move(Index body, const Aabb3d& box) {
  const std::size_t place = place_of(body);
  validation::validate("box", box);
  boxes_[place] = box;
}

void SweptBoxes::remove(Index body) {
  const auto place = static_cast<std::ptrdiff_t>(place_of(body));
  boxes_.erase(boxes_.begin() + place);
  bodies_.erase(bodies_.begin() + place);
}

std::vector<IndexPair> SweptBoxes::pairs() const {
  std::vector<IndexPair> pairs = structures::swept_pairs(boxes_);
  for (IndexPair& pair : pairs) pair = IndexPair{bodies_[pair.i], bodies_[pair.j]};
  return pairs;
}

}  // namespace touchstone::robust
