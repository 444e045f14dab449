// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "catalogue/families/box_draws.h"
#include "catalogue/families/list_draws.h"
#include "catalogue/families/space_draws.h"
#include "geometry/volumes.h"

/// k-DOPs, drawn from a draw stream.
namespace touchstone::catalogue {

inline double product(const Vector3d& n, const Point3d& p) { return dot(n, Vector3d{p.x, p.y, p.z}); }

/// The directions that k-DOPs mostly have: components -1, 0, 1; (1, 0, 0) is the simplest.
inline Vector3d usual_normal(DrawStream& draws) {
  const double x = 1 - up_to(draws, 1), y = small_integer(draws, 1), z = small_integer(draws, 1);
  return x == 0 && y == 0 && z == 0 ? Vector3d{0, 0, 1} : Vector3d{x, y, z};
}

/// The normals of a 26-DOP, 13 of them: the first 3, 7 and 9 are those of a box, a 14-DOP and an 18-DOP. Any lattice
/// vector after these.
inline Vector3d normal_in_turn(std::size_t place, DrawStream& draws) {
  static constexpr Vector3d normals[]{{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 1},  {1, 1, -1}, {1, -1, 1}, {1, -1, -1},
                                      {1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1},  {0, 1, -1}};
  return place < std::size(normals) ? normals[place] : lattice_normal(draws, 8);
}
inline std::vector<Vector3d> many_normals(DrawStream& draws) {
  std::size_t place = 0;
  return long_list(draws, [&place](DrawStream& c) { return normal_in_turn(place++, c); });
}

/// A lattice vector, mostly such a one.
inline Vector3d kdop_normal(DrawStream& draws) { return draws.one_in(4) ? lattice_normal(draws) : usual_normal(draws); }

/// Slabs one after another ("one more?"), so that the draws of one can be cut out and leave the others as they are.
/// slab(draws, normal)
template <class DrawNormal, class DrawSlab>
Kdop3d kdop_of(DrawStream& draws, const DrawNormal& normal, const DrawSlab& slab) {
  Kdop3d kdop;
  do {
    kdop.normals.push_back(normal(draws));
    kdop.slabs.push_back(slab(draws, kdop.normals.back()));
  } while (kdop.normals.size() < 9 && draws.below(4) != 0);
  return kdop;
}

/// Random numbers made a valid k-DOP: as many slabs as normals, their ends in order.
inline void repair(Kdop3d& kdop) {
  const std::size_t count = std::min(kdop.normals.size(), kdop.slabs.size());
  kdop.normals.resize(count), kdop.slabs.resize(count);
  for (Slabd& slab : kdop.slabs) put_in_order(slab.min, slab.max);
}

}  // namespace touchstone::catalogue
