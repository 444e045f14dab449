// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/broad_phase/bounding_volume_hierarchy.h"
#include "proptests/laws.h"
#include "robust/structures/box_tree.h"
#include "robust/structures/swept_boxes.h"

namespace touchstone::proptests::bounding_volume_hierarchy_tests {
namespace {

using Row = rows::bounding_volume_hierarchy;
using Pairs = std::vector<IndexPair>;

Aabb3d along_x(double low, double high) { return {{low, 0, 0}, {high, 1, 1}}; }

/// A tree of so many boxes in a row, from the least to the greatest, with its pairs.
robust::BoxTree row_of(Index count) {
  robust::BoxTree tree;
  for (Index i = 0; i < count; ++i) CHECK(tree.insert(along_x(2.0 * i, 2.0 * i + 1)) == i);
  return tree;
}

}  // namespace

ROBUST_LAW("bounding_volume_hierarchy: after every command each node is exactly around what is below it", boxes,
           commands) {
  std::string defect;
  const auto see = [&defect](const robust::BoxTree& tree) {
    if (defect.empty()) defect = tree.defect();
  };
  const Replies found = replies(robust::BoxTree{}, boxes, commands, see);
  INFO(defect);
  return defect.empty() && found == ask(asked);
}

TEST_CASE("BoxTree: what is inserted in order is balanced, and what is left when half is removed") {
  robust::BoxTree tree = row_of(1000);
  CHECK(tree.defect().empty());
  CHECK(tree.pairs().empty());
  CHECK(tree.in_box(along_x(499.5, 504)) == std::vector<Index>{250, 251, 252});
  for (Index i = 0; i < 1000; i += 2) tree.remove(i);
  CHECK(tree.defect().empty());
  CHECK(tree.in_box(along_x(499.5, 504)) == std::vector<Index>{251});
  for (Index i = 1; i < 1000; i += 2) tree.remove(i);
  CHECK(tree.defect().empty());
  CHECK(tree.pairs().empty());
  CHECK(tree.insert(along_x(0, 1)) == 1000);
  CHECK(tree.in_box(along_x(1, 1)) == std::vector<Index>{1000});
}

TEST_CASE("BoxTree: a body that moves far away and back, many times, is found where it is") {
  robust::BoxTree tree = row_of(40);
  for (int i = 0; i < 200; ++i) {
    tree.move(20, along_x(1e300, 1.5e300));
    CHECK(tree.in_box(along_x(40, 41)).empty());
    CHECK(tree.along_ray({{-1, 0.5, 0.5}, {1, 0, 0}}).back() == 20);
    tree.move(20, along_x(40, 41));
    CHECK(tree.in_box(along_x(40, 41)) == std::vector<Index>{20});
  }
  CHECK(tree.defect().empty());
}

TEST_CASE("BoxTree: what is refused changes nothing") {
  robust::BoxTree tree = row_of(3);
  tree.move(2, along_x(1, 2));
  const auto refuses = [&](const auto& change, const std::string& complaint) {
    CHECK_THROWS_WITH(change(), complaint);
    CHECK(tree.defect().empty());
    CHECK(tree.pairs() == Pairs{{0, 2}, {1, 2}});
  };
  refuses([&] { tree.insert(along_x(1, 0)); }, "box.max[0]: min <= max");
  refuses([&] { tree.move(0, along_x(0, infinity)); }, "box.max[0]: finite number");
  refuses([&] { tree.move(3, along_x(0, 1)); }, "body: index of a body that is there");
  refuses([&] { tree.remove(9); }, "body: index of a body that is there");
  refuses([&] { tree.in_box(along_x(1, 0)); }, "box.max[0]: min <= max");
  refuses([&] { tree.at_point({0, infinity, 0}); }, "point[1]: finite number");
  refuses([&] { tree.along_ray({{0, 0, 0}, {0, 0, 0}}); }, "ray.direction: nonzero direction");
  tree.remove(2);
  CHECK_THROWS_AS(tree.remove(2), InvalidInput);
  CHECK(tree.insert(along_x(0, 9)) == 3);
  CHECK(tree.pairs() == Pairs{{0, 3}, {1, 3}});
}

}  // namespace touchstone::proptests::bounding_volume_hierarchy_tests
