// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/ball_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/spheres.h"
#include "robust/structures/sort_and_sweep.h"

namespace touchstone::robust {
namespace {

constexpr double u = 0x1p-53;

/// At least x (1 + 6 u) for x >= 0; x itself if x is subnormal.
double raised(double x) { return x * (1 + 8 * u); }

/// An upper bound of the distance of two points.
///
/// Rounding is to nearest with gradual underflow. Differences are off by u of them, or exact if subnormal. If the
/// greatest is between 2^-500 and 2^500, squares that underflow lose less than 2^-70 of the sum, the others u each,
/// sums 2 u, and the root half of all that and u: with the differences' less than 4 u. Otherwise the sum of all three
/// is at least the distance, and off by less than 4 u, or exact if subnormal. Raising covers that. Not proved by
/// machine.
double distance_above(const Point3d& p, const Point3d& q) {
  const double x = std::fabs(p.x - q.x), y = std::fabs(p.y - q.y), z = std::fabs(p.z - q.z);
  const double greatest = std::max({x, y, z});
  if (greatest > 0x1p-500 && greatest < 0x1p500) return raised(std::sqrt(x * x + y * y + z * z));
  return raised(x + y + z);
}

/// A ball that contains both. Its center may be rounded: the radius covers the point that is then farthest.
Sphere3d around(const Sphere3d& a, const Sphere3d& b) {
  const auto reach = [](const Point3d& center, const Sphere3d& ball) {
    return raised(distance_above(center, ball.center) + ball.radius);
  };
  if (reach(a.center, b) <= a.radius) return a;
  if (reach(b.center, a) <= b.radius) return b;
  const double displacement = distance_above(a.center, b.center), past = 0.5 * (b.radius - a.radius);
  // Halfway between the far ends; anywhere between the centers if that cannot be computed.
  const double share =
      displacement > 0 && displacement < 0x1p1000 ? std::clamp(0.5 + past / displacement, 0.0, 1.0) : 0.5;
  const auto between = [share](double p, double q) {
    return std::clamp((1 - share) * p + share * q, std::min(p, q), std::max(p, q));
  };
  const Point3d center{between(a.center.x, b.center.x), between(a.center.y, b.center.y),
                       between(a.center.z, b.center.z)};
  return {center, std::max(reach(center, a), reach(center, b))};
}

bool meet(const Sphere3d& a, const Sphere3d& b) {
  if (!validation::finite(a.radius) || !validation::finite(b.radius)) return true;
  return kernel::Reach::ask(a, b).answer >= 0;
}

double Point3d::*longest_axis(const std::vector<Sphere3d>& spheres, const std::vector<Index>& order, std::size_t first,
                              std::size_t last) {
  const kernel::ControlWord guard;
  double Point3d::*longest = &Point3d::x;
  double most = -1;
  for (double Point3d::*axis : {&Point3d::x, &Point3d::y, &Point3d::z}) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = first; i < last; ++i) {
      const double at = spheres[order[i]].center.*axis;
      low = std::min(low, at), high = std::max(high, at);
    }
    if (0.5 * high - 0.5 * low > most) most = 0.5 * high - 0.5 * low, longest = axis;
  }
  return longest;
}

}  // namespace

BallTree::BallTree(const std::vector<Sphere3d>& spheres) {
  validation::validate_numbers("spheres", spheres);
  for (std::size_t i = 0; i < spheres.size(); ++i)
    validation::validate("spheres[" + std::to_string(i) + "]", spheres[i]);
  std::vector<Index> order(spheres.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
  if (!order.empty()) made(order, 0, order.size(), spheres);
}

/// The node of the balls order[first] ... order[last - 1]: split in half along the axis with the widest spread of
/// centers.
Index BallTree::made(std::vector<Index>& order, std::size_t first, std::size_t last,
                     const std::vector<Sphere3d>& spheres) {
  Node node;
  if (last - first == 1) {
    node.place = order[first], node.ball = spheres[node.place];
  } else {
    const auto begin = order.begin();
    const std::size_t half = first + (last - first) / 2;
    const auto axis = longest_axis(spheres, order, first, last);
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(half),
                     begin + static_cast<std::ptrdiff_t>(last), [&](Index i, Index j) {
                       return kernel::ordered_bits(spheres[i].center.*axis) <
                              kernel::ordered_bits(spheres[j].center.*axis);
                     });
    node.leaf = false;
    node.left = made(order, first, half, spheres);
    node.right = made(order, half, last, spheres);
    const kernel::ControlWord guard;
    node.ball = around(nodes_[node.left].ball, nodes_[node.right].ball);
  }
  nodes_.push_back(node);
  return static_cast<Index>(nodes_.size() - 1);
}

/// For two nodes that meet, or one and itself: the larger is opened.
std::vector<IndexPair> BallTree::pairs() const {
  std::vector<IndexPair> pairs;
  std::vector<std::pair<Index, Index>> waiting;
  if (!nodes_.empty()) waiting.emplace_back(nodes_.size() - 1, nodes_.size() - 1);
  while (!waiting.empty()) {
    auto [one, other] = waiting.back();
    waiting.pop_back();
    if (one == other) {
      const Node& n = nodes_[one];
      if (n.leaf) continue;
      waiting.insert(waiting.end(), {{n.left, n.left}, {n.right, n.right}, {n.left, n.right}});
      continue;
    }
    if (!meet(nodes_[one].ball, nodes_[other].ball)) continue;
    if (nodes_[one].leaf && nodes_[other].leaf) {
      const auto [i, j] = std::minmax(nodes_[one].place, nodes_[other].place);
      pairs.push_back({i, j});
      continue;
    }
    // A node's number is greater than those of its descendants.
    if (nodes_[one].leaf || (!nodes_[other].leaf && other > one)) std::swap(one, other);
    waiting.insert(waiting.end(), {{nodes_[one].left, other}, {nodes_[one].right, other}});
  }
  const std::size_t balls = nodes_.size() / 2 + 1;
  return structures::sorted_by(&IndexPair::i, structures::sorted_by(&IndexPair::j, pairs, balls), balls);
}

}  // namespace touchstone::robust
