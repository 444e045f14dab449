// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/validation.h"

/// Rings whose last position repeats the first, as files write them.
namespace touchstone::proptests {

template <class Polygon>
Polygon closed(Polygon ring) {
  ring.vertices.push_back(ring[0]);
  return ring;
}

/// The vertices of a ring of a question.
template <class Polygon>
Polygon opened(const Polygon& ring) {
  return *validation::OpenRing(ring);
}

/// Two positions in a row are one; so the ring from another vertex on may be a closed one.
template <class Polygon>
bool repeats(const Polygon& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (validation::same_position(ring[i], ring.next(i))) return true;
  }
  return false;
}

}  // namespace touchstone::proptests
