// SPDX-License-Identifier: Apache-2.0
#pragma once

// Bullet's broad phases as peers, in single precision: what they share.
#include <bullet/LinearMath/btVector3.h>
#include <touchstone/geometry/volumes.h>

#include <algorithm>

namespace touchstone::bullet_boxes {

using Box = Aabb3<float>;

inline btVector3 vector(const Point3<float>& p) { return {p.x, p.y, p.z}; }
inline void* tagged(std::size_t index) { return reinterpret_cast<void*>(index); }
inline Index index_of(const void* tag) { return static_cast<Index>(reinterpret_cast<std::size_t>(tag)); }

/// Whether a box lies within that distance of the origin on each axis.
inline bool within(const Box& box, float most) {
  const auto& [p, q] = box;
  return std::min({p.x, p.y, p.z}) > -most && std::max({q.x, q.y, q.z}) < most;
}

}  // namespace touchstone::bullet_boxes
