// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/box_tree.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "geometry/validation.h"
#include "robust/structures/along_ray.h"
#include "robust/structures/box_order.h"
#include "robust/structures/pair_tree.h"

namespace touchstone::robust {

using structures::meet;

BoxTree::Place BoxTree::leaf_of(Index body) const {
  if (body >= leaves_.size() || leaves_[body] == none) throw InvalidInput("body", "index of a body that is there");
  return leaves_[body];
}

BoxTree::Place BoxTree::made(const Node& node) {
  if (free_.empty()) {
    nodes_.push_back(node);
    return static_cast<Place>(nodes_.size() - 1);
  }
  const Place place = free_.back();
  free_.pop_back();
  nodes_[place] = node;
  return place;
}

/// The link to a node: a member of its parent, or the root.
BoxTree::Place& BoxTree::link_to(Place node) {
  const Place parent = nodes_[node].parent;
  if (parent == none) return root_;
  return nodes_[parent].left == node ? nodes_[parent].left : nodes_[parent].right;
}

void BoxTree::refit(Place node) {
  Node& n = nodes_[node];
  const Node &left = nodes_[n.left], &right = nodes_[n.right];
  n.box = structures::around(left.box, right.box);
  n.height = 1 + std::max(left.height, right.height);
}

/// If one side is higher by two, its root takes the node's place, and the node takes the lower subtree of that root.
BoxTree::Place BoxTree::balanced(Place node) {
  Node& n = nodes_[node];
  const int lean = nodes_[n.right].height - nodes_[n.left].height;
  if (std::abs(lean) < 2) return node;
  Place& higher_link = lean > 0 ? n.right : n.left;
  const Place up = higher_link;
  Node& raised = nodes_[up];
  const bool left_stays = nodes_[raised.left].height >= nodes_[raised.right].height;
  Place& given_link = left_stays ? raised.right : raised.left;
  const Place given = given_link;
  link_to(node) = up;
  raised.parent = n.parent, n.parent = up;
  given_link = node, higher_link = given;
  nodes_[given].parent = node;
  refit(node), refit(up);
  return up;
}

void BoxTree::refit_upwards(Place node) {
  while (node != none) {
    refit(node);
    node = nodes_[balanced(node)].parent;
  }
}

/// Descends to where the boxes grow least. An estimate: the answers do not depend on it.
BoxTree::Place BoxTree::best_sibling(const Aabb3d& box) const {
  const kernel::ControlWord guard;
  Place at = root_;
  while (nodes_[at].height > 0) {
    const auto growth = [&](Place child) {
      const Aabb3d& own = nodes_[child].box;
      return structures::size(structures::around(own, box)) - structures::size(own);
    };
    const Node& n = nodes_[at];
    at = growth(n.left) <= growth(n.right) ? n.left : n.right;
  }
  return at;
}

void BoxTree::hang(Place leaf) {
  if (root_ == none) {
    root_ = leaf, nodes_[leaf].parent = none;
    return;
  }
  const Place sibling = best_sibling(nodes_[leaf].box);
  const Place parent = made({{}, nodes_[sibling].parent, sibling, leaf});
  link_to(sibling) = parent;
  nodes_[sibling].parent = nodes_[leaf].parent = parent;
  refit_upwards(parent);
}

void BoxTree::unhang(Place leaf) {
  const Place parent = nodes_[leaf].parent;
  if (parent == none) {
    root_ = none;
    return;
  }
  const Place sibling = nodes_[parent].left == leaf ? nodes_[parent].right : nodes_[parent].left;
  link_to(parent) = sibling;
  nodes_[sibling].parent = nodes_[parent].parent;
  free_.push_back(parent);
  refit_upwards(nodes_[sibling].parent);
}

Index BoxTree::insert(const Aabb3d& box) {
  validation::validate("box", box);
  const auto body = static_cast<Index>(leaves_.size());
  Node leaf;
  leaf.box = box, leaf.body = body;
  leaves_.push_back(made(leaf));
  hang(leaves_.back());
  return body;
}

void BoxTree::move(Index body, const Aabb3d& box) {
  const Place leaf = leaf_of(body);
  validation::validate("box", box);
  unhang(leaf);
  nodes_[leaf].box = box;
  hang(leaf);
}

void BoxTree::remove(Index body) {
  const Place leaf = leaf_of(body);
  unhang(leaf);
  free_.push_back(leaf);
  leaves_[body] = none;
}

/// Calls found(leaf) for each body for which, as for all nodes above it, `meet(box)` is true.
template <class Meet, class Found>
void BoxTree::search(const Meet& meet, const Found& found) const {
  if (root_ == none) return;
  std::vector<Place> waiting{root_};
  while (!waiting.empty()) {
    const Node& n = nodes_[waiting.back()];
    waiting.pop_back();
    if (!meet(n.box)) continue;
    if (n.height == 0) found(n);
    else waiting.push_back(n.left), waiting.push_back(n.right);
  }
}

/// Builds a tree for this query: one that has grown by insertions separates its boxes less well.
std::vector<IndexPair> BoxTree::pairs() const {
  std::vector<Aabb3d> boxes;
  std::vector<Index> bodies;
  for (Index body = 0; body < leaves_.size(); ++body) {
    if (leaves_[body] != none) boxes.push_back(nodes_[leaves_[body]].box), bodies.push_back(body);
  }
  std::vector<IndexPair> pairs = structures::tree_pairs(boxes);
  for (IndexPair& pair : pairs) pair = IndexPair{bodies[pair.i], bodies[pair.j]};
  return pairs;
}

std::vector<Index> BoxTree::in_box(const Aabb3d& box) const {
  validation::validate("box", box);
  std::vector<Index> bodies;
  search([&box](const Aabb3d& other) { return meet(box, other); },
         [&bodies](const Node& leaf) { bodies.push_back(leaf.body); });
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

std::vector<Index> BoxTree::at_point(const Point3d& point) const {
  validation::validate("point", point);
  return in_box({point, point});
}

std::vector<Index> BoxTree::along_ray(const Ray3d& ray) const {
  validation::validate("ray", ray);
  const kernel::ControlWord guard;
  std::vector<std::pair<structures::Moment, Index>> met;
  search([&ray](const Aabb3d& box) { return structures::first_moment(ray, box).has_value(); },
         [&](const Node& leaf) { met.emplace_back(*structures::first_moment(ray, leaf.box), leaf.body); });
  return structures::in_order(std::move(met));
}

std::string BoxTree::defect() const {
  std::vector<Place> waiting;
  std::size_t leaves = 0, inner = 0;
  if (root_ != none) {
    if (nodes_[root_].parent != none) return "the root has a parent";
    waiting.push_back(root_);
  }
  while (!waiting.empty()) {
    const Place place = waiting.back();
    const Node& n = nodes_[place];
    waiting.pop_back();
    if (n.height == 0) {
      if (leaves_.at(n.body) != place) return "a body is in another place";
      ++leaves;
      continue;
    }
    ++inner;
    const Node &left = nodes_[n.left], &right = nodes_[n.right];
    if (left.parent != place || right.parent != place) return "a node does not know its parent";
    if (!structures::same(n.box, structures::around(left.box, right.box))) return "a box is not that of its two parts";
    if (n.height != 1 + std::max(left.height, right.height)) return "a height is wrong";
    if (std::abs(left.height - right.height) > 1) return "the tree is not balanced";
    waiting.push_back(n.left), waiting.push_back(n.right);
  }
  const auto there =
      static_cast<std::size_t>(std::count_if(leaves_.begin(), leaves_.end(), [](Place leaf) { return leaf != none; }));
  if (leaves != there) return "a body is missing";
  if (leaves + inner + free_.size() != nodes_.size()) return "a node is lost";
  return "";
}

}  // namespace touchstone::robust
