// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/near_triangles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace touchstone::oracle {
namespace {

using CoordinateOfPoint = Integer Point3<Integer>::*;

/// The rank of each point's coordinate among all distinct ones: ranks compare as the coordinates do.
std::vector<Index> ranks(const IntegerCloud& cloud, CoordinateOfPoint axis) {
  std::vector<Index> order(cloud.size()), rank(cloud.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return cloud[a].*axis < cloud[b].*axis; });
  for (std::size_t k = 1; k < order.size(); ++k)
    rank[order[k]] = rank[order[k - 1]] + (cloud[order[k - 1]].*axis < cloud[order[k]].*axis ? 1 : 0);
  return rank;
}

struct Interval {
  Index low, high;
  bool meets(const Interval& other) const { return low <= other.high && other.low <= high; }
};

using RankBox = std::array<Interval, 3>;

std::vector<RankBox> boxes_of(const IntegerCloud& cloud, const std::vector<Face>& triangles) {
  const std::array<CoordinateOfPoint, 3> axes{&Point3<Integer>::x, &Point3<Integer>::y, &Point3<Integer>::z};
  std::vector<RankBox> boxes(triangles.size());
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<Index> rank = ranks(cloud, axes[k]);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto [low, high] = std::minmax({rank[triangles[i].a], rank[triangles[i].b], rank[triangles[i].c]});
      boxes[i][k] = {low, high};
    }
  }
  return boxes;
}

}  // namespace

std::vector<std::vector<Index>> later_triangles_near(const IntegerCloud& cloud, const std::vector<Face>& triangles) {
  const std::vector<RankBox> boxes = boxes_of(cloud, triangles);
  std::vector<Index> order(triangles.size()), reached;
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return boxes[i][0].low < boxes[j][0].low; });
  std::vector<std::vector<Index>> later(triangles.size());
  for (const Index i : order) {
    std::erase_if(reached, [&](Index j) { return boxes[j][0].high < boxes[i][0].low; });
    for (const Index j : reached)
      if (boxes[i][1].meets(boxes[j][1]) && boxes[i][2].meets(boxes[j][2]))
        later[std::min(i, j)].push_back(std::max(i, j));
    reached.push_back(i);
  }
  for (std::vector<Index>& near : later) std::sort(near.begin(), near.end());
  return later;
}

}  // namespace touchstone::oracle
