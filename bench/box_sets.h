// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "geometry/volumes.h"

/// Lists of boxes, with about four pairs a box unless stated otherwise.
namespace touchstone::bench {

inline constexpr std::array box_sets{
    "uniform",     ///< in the unit cube, of similar sizes
    "clustered",   ///< 64 normal clusters
    "six_orders",  ///< sizes over six orders of magnitude
    "nine_orders",
    "one_huge",    ///< uniform, and one box that encloses all
    "lattice",     ///< cells of a grid that share their faces to the last bit
    "nested",      ///< clusters in clusters, over 400 binades
    "sticks",      ///< as long as the cube on one axis, thin on the others
    "flat",        ///< in one plane
    "duplicates",  ///< each box four times
    "equal",       ///< all equal; all meet
    "points",      ///< points of a small grid
    "zeros",       ///< -0.0, 0.0 and their neighbours
    "extreme",     ///< up to the largest double
};

class BoxNumbers {
 public:
  explicit BoxNumbers(std::uint64_t seed) : bits_(seed) {}
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits_() % n); }
  double normal() {
    const double u = unit() + 1e-300, v = unit();
    return std::sqrt(-2 * std::log(u)) * std::cos(6.283185307179586 * v);
  }

 private:
  std::mt19937_64 bits_;
};

/// The ends on one axis.
using Ends = std::pair<double, double>;

inline Ends ordered_ends(double p, double q) { return {std::min(p, q), std::max(p, q)}; }

inline Ends extreme_ends(BoxNumbers& draw, double x) {
  constexpr double most = std::numeric_limits<double>::max();
  switch (draw.below(8)) {
    case 0: return {-most, x};
    case 1: return {x, most};
    case 2: return {most, most};
    case 3:
    case 4:
    case 5: {
      const double p = std::ldexp(2 * x - 1, static_cast<int>(draw.below(2040)) - 1016), q = p * (1 + draw.unit());
      return ordered_ends(p, q);
    }
    default: return {x, x + 0.1};
  }
}

inline std::vector<Aabb3d> box_set(const std::string& set, std::size_t n, std::uint64_t seed) {
  BoxNumbers draw(seed);
  const double spacing = std::cbrt(1.0 / static_cast<double>(n + 1));
  std::array<std::array<double, 3>, 64> centers{};
  for (auto& center : centers)
    for (double& x : center) x = draw.unit();
  std::size_t side = 1;
  while (side * side * side < n) ++side;
  const int orders = set == "six_orders" ? 6 : set == "nine_orders" ? 9 : 0;
  std::vector<Aabb3d> boxes;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t cluster = draw.below(64), along = draw.below(3);
    double size = spacing * (0.5 + draw.unit());
    if (set == "clustered") size *= 0.283;
    if (orders > 0) size = 5 * spacing * std::pow(10.0, -orders * draw.unit());
    const std::array cell{i % side, i / side % side, i / side / side};
    std::array<Ends, 3> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      double x = draw.unit(), width = size * (0.5 + (orders > 0 ? 0.5 : 1) * draw.unit());
      if (set == "clustered") x = centers[cluster][k] + 0.02 * draw.normal();
      if (set == "sticks") width = k == along ? 1 : 1e-3 * spacing;
      ends[k] = {x - width / 2, x + width / 2};
      if (set == "flat" && k == 2) ends[k] = {0.25, 0.25};
      if (set == "equal") ends[k] = {0.25, 0.75};
      if (set == "lattice") ends[k] = {static_cast<double>(cell[k]) * 0.1, static_cast<double>(cell[k] + 1) * 0.1};
      if (set == "extreme") ends[k] = extreme_ends(draw, x);
      if (set == "points") {
        const auto p = static_cast<double>(draw.below(side));
        ends[k] = {p, p};
      }
      if (set == "nested") {
        const double p = std::ldexp(1 + draw.unit(), -static_cast<int>(draw.below(400)));
        ends[k] = {p, p * (1 + spacing)};
      }
      if (set == "zeros") {
        constexpr std::array near{-1.0, -0x1p-1074, -0.0, 0.0, 0x1p-1074, 1.0};
        const std::size_t p = draw.below(6), q = draw.below(6);
        ends[k] = {near[std::min(p, q)], near[std::max(p, q)]};
      }
    }
    boxes.push_back({{ends[0].first, ends[1].first, ends[2].first}, {ends[0].second, ends[1].second, ends[2].second}});
    if (set == "duplicates" && i % 4 > 0) boxes[i] = boxes[i - 1];
  }
  if (set == "one_huge" && n > 0) boxes[draw.below(n)] = {{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}};
  if (set == "lattice") {
    for (std::size_t i = n; i > 1; --i) std::swap(boxes[i - 1], boxes[draw.below(i)]);
  }
  return boxes;
}

}  // namespace touchstone::bench
