// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

#include "geometry/polyhedra.h"
#include "robust/kernel/minkowski/difference_faces.h"

namespace touchstone::robust::kernel {

/// Along a direction n of any length b reaches beyond the beginning of a by height / (total |n|) * 2^exponent; of_a and
/// of_b: the vertices that are farthest against the direction and along it, in ascending order.
struct CoreOverlap {
  Vector3<mpz_class> direction;
  mpz_class height, total;
  int exponent;
  std::vector<Index> of_a, of_b;
};

/// The least overlap of cores that have a common point: convex solids, or simplices (geometry/penetration.h); of
/// several the one of the least of_a, then of_b, in lexicographic order. Where their difference has no inside, it is
/// the one at a right angle to it whose unit vector is the lexicographically greatest. The numbers are finite. It takes
/// as many steps as there are pairs of edges.
CoreOverlap least_overlap(const Meshd& a, const Meshd& b);

/// The same where `faces` are the nearest ones of the Minkowski difference; nothing if one of them does not bound it.
std::optional<CoreOverlap> least_of_faces(const Meshd& a, const Meshd& b, const std::vector<DifferenceFace>& faces);

}  // namespace touchstone::robust::kernel
