// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/triangle_orbits.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>

#include "geometry/invalid_input.h"

namespace touchstone::catalogue {
namespace {

constexpr int greatest_size = 6;

using Places = std::array<int, 3>;

/// The number of orders of three places.
std::uint64_t orders(const Places& p) { return p[0] == p[2] ? 1 : p[0] == p[1] || p[1] == p[2] ? 3 : 6; }

/// The image of each place under each of the 48 maps: axes in another order, some of them reversed.
std::vector<std::vector<int>> symmetries(int size) {
  std::vector<std::vector<int>> maps;
  std::array<int, 3> axes{0, 1, 2};
  do {
    for (int turned = 0; turned < 8; ++turned) {
      std::vector<int> map;
      for (int place = 0; place < size * size * size; ++place) {
        std::array<int, 3> digits{place % size, place / size % size, place / size / size};
        for (int i = 0; i < 3; ++i)
          if (turned >> i & 1) digits[static_cast<std::size_t>(i)] = size - 1 - digits[static_cast<std::size_t>(i)];
        const auto along = [&](std::size_t i) { return digits[static_cast<std::size_t>(axes[i])]; };
        map.push_back(along(0) + size * (along(1) + size * along(2)));
      }
      maps.push_back(std::move(map));
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return maps;
}

}  // namespace

TriangleOrbits::TriangleOrbits(int size) : size_(size) {
  const int places = size * size * size;
  for (int a = 0; a < places; ++a)
    for (int b = a; b < places; ++b)
      for (int c = b; c < places; ++c) sets_.push_back({{a, b, c}, orders({a, b, c})});
  const auto maps = symmetries(size);
  std::map<Places, std::uint64_t> weights;  // by the least set of each orbit
  for (const Corners& corners : sets_) {
    Places least = corners.places;
    for (const auto& map : maps) {
      Places moved;
      for (std::size_t i = 0; i < 3; ++i) moved[i] = map[static_cast<std::size_t>(corners.places[i])];
      std::sort(moved.begin(), moved.end());
      least = std::min(least, moved);
    }
    weights[least] += corners.weight;
  }
  for (const auto& [places_of_least, weight] : weights) orbits_.push_back({places_of_least, weight});
}

const TriangleOrbits& TriangleOrbits::of(int size) {
  if (size > greatest_size) throw InvalidInput("--grid", "at most 6 for pairs of triangles");
  static std::array<std::once_flag, greatest_size + 1> once;
  static std::array<std::unique_ptr<const TriangleOrbits>, greatest_size + 1> made;
  const auto at = static_cast<std::size_t>(size);
  std::call_once(once[at], [&] { made[at].reset(new TriangleOrbits(size)); });
  return *made[at];
}

}  // namespace touchstone::catalogue
