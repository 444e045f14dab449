// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

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
  const Polygon2d& ring() const { return ring_; }
  const structures::RingTree& tree() const { return tree_; }

 private:
  Polygon2d ring_;
  structures::RingTree tree_;
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

}  // namespace touchstone::robust
