// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/answers.h"
#include "geometry/thin_shapes.h"
#include "oracle/exact/numbers/decode.h"
#include "oracle/truth.h"

/// Areas in the plane by all of their edges, in integers of one unit: a vertical line that misses every vertex is
/// inside between its first crossing and its second, its third and its fourth and so on. Slabs are what lies between
/// adjacent cuts: inside a slab no edge of one area crosses an edge of the other.
namespace touchstone::oracle {

struct Arrangement {
  std::vector<Rational> cuts;             ///< ascending: the x of every vertex and of every crossing
  std::optional<Point2<Rational>> touch;  ///< a common point of the boundaries
};
Arrangement arrangement_of(const std::vector<Segment2<Integer>>& a, const std::vector<Segment2<Integer>>& b);

/// A point on the middle line of a slab inside both areas.
std::optional<Point2<Rational>> common_interior_point(const std::vector<Segment2<Integer>>& a,
                                                      const std::vector<Segment2<Integer>>& b,
                                                      const std::vector<Rational>& cuts);
/// On the middle line of every slab, what is inside b is inside a.
bool covers(const std::vector<Segment2<Integer>>& a, const std::vector<Segment2<Integer>>& b,
            const std::vector<Rational>& cuts);

/// The contact of two areas; its margin is the least squared distance of a vertex of one from an edge of the other. The
/// certificate is described at oracle/polygons/polygon_polygon.h.
Truth<Contact> contact_by_slabs(const std::vector<Segment2<Integer>>& a, const std::vector<Segment2<Integer>>& b,
                                const Rational& unit);

}  // namespace touchstone::oracle
