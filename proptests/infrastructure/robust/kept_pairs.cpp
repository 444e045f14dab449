// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <random>

#include "proptests/catch.h"
#include "robust/pairs/forest.h"
#include "robust/structures/pair_tree.h"

/// A forest that is kept while boxes move lists what comparing all pairs does.
namespace touchstone::proptests::kept_pairs_tests {
namespace {

using robust::pairs::KeptForest;
using Pairs = std::vector<IndexPair>;

Pairs by_comparing_all(const std::vector<Aabb3d>& boxes) {
  Pairs pairs;
  for (Index i = 0; i < boxes.size(); ++i) {
    for (Index j = i + 1; j < boxes.size(); ++j) {
      const auto& [a, b] = std::tie(boxes[i], boxes[j]);
      if (a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
          b.min.z <= a.max.z)
        pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Whole numbers times a power of 2, from an engine that the standard defines.
class Boxes {
 public:
  explicit Boxes(std::uint64_t seed, double unit) : engine_(seed), unit_(unit) {}

  double between(int low, int high) {
    const auto range = static_cast<std::uint64_t>(high - low + 1);
    return static_cast<double>(low + static_cast<int>(engine_() % range)) * unit_;
  }
  Aabb3d one(int room, int widest) {
    Aabb3d box;
    for (double Point3d::*axis : {&Point3d::x, &Point3d::y, &Point3d::z}) {
      box.min.*axis = between(-room, room);
      box.max.*axis = box.min.*axis + between(0, widest);
    }
    return box;
  }
  void move(Aabb3d& box, int far) {
    for (double Point3d::*axis : {&Point3d::x, &Point3d::y, &Point3d::z}) {
      const double displacement = between(-far, far);
      box.min.*axis += displacement, box.max.*axis += displacement;
    }
  }

 private:
  std::mt19937_64 engine_;
  double unit_;
};

}  // namespace

TEST_CASE("kept pairs: while boxes move a little, or leap, the pairs are those of all, in order") {
  std::size_t found = 0;
  for (const double unit : {1.0, 0x1p-1074, 0x1p1000}) {
    for (const int far : {0, 1, 5, 60}) {
      Boxes draw(static_cast<std::uint64_t>(far) + 1, unit);
      std::vector<Aabb3d> boxes;
      for (int i = 0; i < 150; ++i) boxes.push_back(draw.one(60, i % 10 == 0 ? 40 : 12));
      KeptForest kept;
      for (int round = 0; round < 30; ++round) {
        const Pairs right = by_comparing_all(boxes);
        REQUIRE(kept.pairs(boxes) == right);
        REQUIRE(robust::structures::tree_pairs(boxes) == right);
        found += right.size();
        for (Aabb3d& box : boxes) draw.move(box, far);
      }
    }
  }
  CHECK(found > 5000);
}

TEST_CASE("kept pairs: another number of boxes, none, all in one place, and back again") {
  Boxes draw(7, 0.5);
  KeptForest kept;
  for (const std::size_t many : {20U, 21U, 0U, 0U, 1U, 8U, 9U, 200U, 200U, 20U}) {
    std::vector<Aabb3d> boxes;
    for (std::size_t i = 0; i < many; ++i) boxes.push_back(draw.one(20, 8));
    CHECK(kept.pairs(boxes) == by_comparing_all(boxes));
    for (Aabb3d& box : boxes) box = {{1, 1, 1}, {1, 1, 1}};
    CHECK(kept.pairs(boxes).size() == many * (many - std::min<std::size_t>(many, 1)) / 2);
  }
}

TEST_CASE("kept pairs: from one end of the range to the other") {
  constexpr double most = std::numeric_limits<double>::max();
  Boxes draw(3, 1);
  std::vector<Aabb3d> boxes;
  for (int i = 0; i < 60; ++i) boxes.push_back(draw.one(10, 3));
  KeptForest kept;
  CHECK(kept.pairs(boxes) == by_comparing_all(boxes));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const double side = i % 2 == 0 ? most : -most;
    if (i % 3 == 0) boxes[i] = {{side, side, side}, {side, side, side}};
    if (i % 7 == 0) boxes[i] = {{-most, -most, -most}, {most, most, most}};
  }
  CHECK(kept.pairs(boxes) == by_comparing_all(boxes));
  for (Aabb3d& box : boxes) box = {{-most, 0, 0}, {-most, 1, 1}};
  CHECK(kept.pairs(boxes) == by_comparing_all(boxes));
}

}  // namespace touchstone::proptests::kept_pairs_tests
