// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/body_tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace touchstone::oracle {
namespace {

using Box = Aabb3<Rational>;

void enlarge(std::optional<Box>& around, const Box& box) {
  if (!around) {
    around = box;
    return;
  }
  for (const auto axis : axes_of_boxes) {
    if (box.min.*axis < around->min.*axis) around->min.*axis = box.min.*axis;
    if (around->max.*axis < box.max.*axis) around->max.*axis = box.max.*axis;
  }
}

}  // namespace

/// Twice the middle of a body's box.
struct BodyTree::Middle {
  Index body;
  std::array<Rational, 3> at;
};

BodyTree::BodyTree(const Bodies& bodies) {
  std::vector<Middle> middles;
  for (const auto& [body, box] : bodies) {
    middles.push_back({body, {}});
    for (std::size_t k = 0; k < 3; ++k) middles.back().at[k] = box.min.*axes_of_boxes[k] + box.max.*axes_of_boxes[k];
  }
  if (!middles.empty()) divide(middles, 0, middles.size());
  for (const Middle& middle : middles) order_.push_back(middle.body);
  in_order_.insert(order_.begin(), order_.end());
  refit(bodies);
}

void BodyTree::divide(std::vector<Middle>& middles, std::size_t begin, std::size_t end) {
  const std::size_t place = nodes_.size();
  nodes_.push_back({begin, end, 0});
  if (end - begin <= largest_leaf) return;
  const auto first = middles.begin() + static_cast<std::ptrdiff_t>(begin),
             last = middles.begin() + static_cast<std::ptrdiff_t>(end);
  const auto before_on = [](std::size_t k) {
    return [k](const Middle& a, const Middle& b) { return a.at[k] < b.at[k]; };
  };
  std::size_t widest = 0;
  Rational greatest = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(first, last, before_on(k));
    const Rational extent = high->at[k] - low->at[k];
    if (extent > greatest) greatest = extent, widest = k;
  }
  std::stable_sort(first, last, before_on(widest));
  const std::size_t half = begin + (end - begin) / 2;
  divide(middles, begin, half);
  nodes_[place].second = nodes_.size();
  divide(middles, half, end);
}

void BodyTree::refit(const Bodies& bodies) {
  for (std::size_t place = nodes_.size(); place-- > 0;) {
    Node& node = nodes_[place];
    node.box.reset();
    if (node.second != 0) {
      for (const std::size_t child : {place + 1, node.second})
        if (nodes_[child].box) enlarge(node.box, *nodes_[child].box);
      continue;
    }
    for (std::size_t i = node.begin; i < node.end; ++i)
      if (const auto body = bodies.find(order_[i]); body != bodies.end()) enlarge(node.box, body->second);
  }
  others_.clear();
  for (const auto& [body, box] : bodies)
    if (!in_order_.contains(body)) others_.push_back(body);
}

Certificate BodyTree::certificate() const {
  std::vector<Rational> cuts;
  for (std::size_t place = 0; place < nodes_.size(); ++place)
    cuts.emplace_back(nodes_[place].second == 0 ? 0 : nodes_[place + 1].end - nodes_[place].begin);
  return {"tree", {{"order", {order_.begin(), order_.end()}}, {"cuts", std::move(cuts)}}};
}

}  // namespace touchstone::oracle
