// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "geometry/triangles.h"

namespace touchstone::catalogue {

/// Pairs of triangles with corners on the grid of size^3. The order of corners changes no answer, nor does a symmetry
/// of the grid (48 of them): so a pair stands for all ordered pairs of triangles that it becomes by them. One first
/// triangle of each orbit is asked, with every set of corners as the second.
class TriangleOrbits {
 public:
  /// Made once for each size. Throws InvalidInput beyond 6, where the sets would be too many to list.
  static const TriangleOrbits& of(int size);

  std::uint64_t count() const { return orbits_.size() * sets_.size(); }
  std::tuple<Triangle3d, Triangle3d> at(std::uint64_t index) const {
    return {triangle(orbits_[index / sets_.size()]), triangle(sets_[index % sets_.size()])};
  }
  /// For how many ordered pairs it stands; all of them together are size^18.
  std::uint64_t weight(std::uint64_t index) const {
    return orbits_[index / sets_.size()].weight * sets_[index % sets_.size()].weight;
  }

 private:
  struct Corners {
    std::array<int, 3> places;  ///< x + size (y + size z), ascending
    std::uint64_t weight;       ///< ordered triples
  };

  explicit TriangleOrbits(int size);
  Point3d point(int place) const {
    return {static_cast<double>(place % size_), static_cast<double>(place / size_ % size_),
            static_cast<double>(place / size_ / size_)};
  }
  Triangle3d triangle(const Corners& c) const { return {point(c.places[0]), point(c.places[1]), point(c.places[2])}; }

  int size_;
  std::vector<Corners> sets_, orbits_;
};

}  // namespace touchstone::catalogue
