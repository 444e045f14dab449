// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/polygons.h"
#include "robust/prepared/validated.h"
#include "robust/structures/ring_tree.h"

namespace touchstone::robust {

/// A polygon that is validated once and asked many times: any closed ring, as point_in_polygon takes it.
///
/// Never changes once it is made, so threads may share it; a copy copies the ring, and one that was moved from can only
/// be assigned or destroyed. It keeps a tree of boxes, 32 bytes for every sixteen edges: a point costs the parts whose
/// boxes hold it, about log n where these are few, and at worst all n edges. Right for all finite doubles in
/// every floating-point environment. The constructors throw InvalidInput, which names `field` and the rule, as the
/// operations do.
class Polygon {
 public:
  explicit Polygon(const Polygon2d& ring, const std::string& field = "polygon");
  Polygon(Validated, Polygon2d ring);

  /// Without a last vertex that repeats the first.
  const Polygon2d& ring() const { return treed_.ring; }
  const structures::RingTree& tree() const { return treed_.tree; }
  const structures::TreedRing& treed() const { return treed_; }

 private:
  structures::TreedRing treed_;
};

/// A polygon that is simple, as polygon_polygon takes it. Its ring runs counter-clockwise, however it was given.
class SimplePolygon : public Polygon {
 public:
  explicit SimplePolygon(const Polygon2d& ring, const std::string& field = "polygon");
  SimplePolygon(Validated, Polygon2d ring);
};

/// A polygon that is convex, as point_in_convex_polygon takes it.
class ConvexPolygon : public SimplePolygon {
 public:
  explicit ConvexPolygon(const Polygon2d& ring, const std::string& field = "polygon");
};

/// A region, as point_in_region and region_region take it: simple rings, with the inside of the region to their left,
/// however they were given.
class Region {
 public:
  explicit Region(const Region2d& region, const std::string& field = "region");

  /// The outer ring, and then the holes in their order.
  const std::vector<Polygon>& rings() const { return rings_; }
  std::vector<const structures::TreedRing*> treed() const;

 private:
  std::vector<Polygon> rings_;
};

}  // namespace touchstone::robust
