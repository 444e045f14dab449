// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/swept_boxes.h"

#include <algorithm>

#include "geometry/validation.h"
#include "robust/structures/along_ray.h"
#include "robust/structures/box_order.h"
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

std::vector<Index> SweptBoxes::in_box(const Aabb3d& box) const {
  validation::validate("box", box);
  std::vector<Index> bodies;
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    if (structures::meet(boxes_[i], box)) bodies.push_back(bodies_[i]);
  return bodies;
}

std::vector<Index> SweptBoxes::at_point(const Point3d& point) const {
  validation::validate("point", point);
  return in_box({point, point});
}

std::vector<Index> SweptBoxes::along_ray(const Ray3d& ray) const {
  validation::validate("ray", ray);
  const kernel::ControlWord guard;
  std::vector<std::pair<structures::Moment, Index>> met;
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    if (const auto first = structures::first_moment(ray, boxes_[i])) met.emplace_back(*first, bodies_[i]);
  return structures::in_order(std::move(met));
}

}  // namespace touchstone::robust
