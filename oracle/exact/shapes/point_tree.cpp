// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/point_tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace touchstone::oracle {
namespace {

constexpr std::size_t largest_leaf = 8;
constexpr std::array axes_of_points{&Point3<Integer>::x, &Point3<Integer>::y, &Point3<Integer>::z};

}  // namespace

PointTree::PointTree(const IntegerCloud& cloud, std::vector<Index> points) : cloud_(cloud), points_(std::move(points)) {
  divide(0, points_.size());
}

void PointTree::divide(std::size_t begin, std::size_t end) {
  const std::size_t place = nodes_.size();
  const auto first = points_.begin() + static_cast<std::ptrdiff_t>(begin),
             last = points_.begin() + static_cast<std::ptrdiff_t>(end);
  Node node{begin, end};
  auto widest = axes_of_points[0];
  Integer greatest = -1;
  for (const auto axis : axes_of_points) {
    const auto [low, high] =
        std::minmax_element(first, last, [&](Index p, Index q) { return cloud_[p].*axis < cloud_[q].*axis; });
    node.low.*axis = cloud_[*low].*axis, node.high.*axis = cloud_[*high].*axis;
    const Integer width = node.high.*axis - node.low.*axis;
    if (width > greatest) greatest = width, widest = axis;
  }
  nodes_.push_back(std::move(node));
  if (end - begin <= largest_leaf) return;
  const std::size_t half = begin + (end - begin) / 2;
  std::nth_element(first, points_.begin() + static_cast<std::ptrdiff_t>(half), last,
                   [&](Index p, Index q) { return cloud_[p].*widest < cloud_[q].*widest; });
  divide(begin, half);
  nodes_[place].second = nodes_.size();
  divide(half, end);
}

bool PointTree::any_beyond(const SupportingPlane& plane, std::size_t place) const {
  const Node& node = nodes_[place];
  Integer most = -plane.level;  // of the box's corner that is farthest along the normal
  const auto add = [&most](const Integer& n, const Integer& low, const Integer& high) {
    most += n * (sgn(n) > 0 ? high : low);
  };
  add(plane.normal.x, node.low.x, node.high.x), add(plane.normal.y, node.low.y, node.high.y);
  add(plane.normal.z, node.low.z, node.high.z);
  if (sgn(most) <= 0) return false;
  if (node.second != 0) return any_beyond(plane, place + 1) || any_beyond(plane, node.second);
  return std::any_of(points_.begin() + static_cast<std::ptrdiff_t>(node.begin),
                     points_.begin() + static_cast<std::ptrdiff_t>(node.end),
                     [&](Index p) { return sgn(cloud_.height(plane, p)) > 0; });
}

}  // namespace touchstone::oracle
