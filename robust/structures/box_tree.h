// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// A bounding volume hierarchy: bodies are inserted, moved and removed in a balanced tree of boxes. For many bodies of
/// which few move between two queries, or few meet; `SweptBoxes` is for all pairs of bodies that all move.
///
/// A body keeps the index that `insert` returned until it is removed; the index is never reused. A box that is not
/// valid throws InvalidInput ("box", "finite number" or "min <= max"), and so do a point that is not finite ("point"),
/// a ray that is not finite or has no direction ("ray.direction", "nonzero direction"), and the index of a missing body
/// ("body", "index of a body that is there"); nothing has changed then.
///
/// All answers are right for all finite doubles in every floating-point environment. After every command the box of
/// each node is the least that contains its two children, exactly: boxes are only compared. The paths from the root
/// differ so little in length that the longest has at most 1.45 log2 n nodes, whatever the commands: each command takes
/// that many steps, as does a query for each body that it finds if boxes overlap little.
class BoxTree {
 public:
  Index insert(const Aabb3d& box);
  void move(Index body, const Aabb3d& box);
  void remove(Index body);

  /// The pairs of bodies i < j that meet, sorted; in the time of robust/structures/pair_tree.h.
  std::vector<IndexPair> pairs() const;
  /// The bodies that meet a box, or contain a point, sorted.
  std::vector<Index> in_box(const Aabb3d& box) const;
  std::vector<Index> at_point(const Point3d& point) const;
  /// The bodies that a ray meets, in the order in which it meets them; those met at the same time by index.
  std::vector<Index> along_ray(const Ray3d& ray) const;

  /// Describes a broken invariant of the tree, for tests: "" if there is none.
  std::string defect() const;

 private:
  using Place = std::uint32_t;
  static constexpr Place none = ~Place{0};
  struct Node {
    Aabb3d box;
    Place parent = none, left = none, right = none;
    int height = 0;  ///< 0 for a body
    Index body = 0;
  };

  Place leaf_of(Index body) const;
  Place made(const Node& node);
  Place& link_to(Place node);
  void hang(Place leaf);
  void unhang(Place leaf);
  Place best_sibling(const Aabb3d& box) const;
  void refit(Place node);
  void refit_upwards(Place node);
  Place balanced(Place node);
  template <class Meet, class Found>
  void search(const Meet& meet, const Found& found) const;

  std::vector<Node> nodes_;
  std::vector<Place> free_;    ///< free nodes
  std::vector<Place> leaves_;  ///< by body; none if it was removed
  Place root_ = none;
};

}  // namespace touchstone::robust
