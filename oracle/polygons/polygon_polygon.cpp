// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/polygon_polygon.h"

#include <vector>

#include "geometry/validation.h"
#include "oracle/rings/simple.h"
#include "oracle/rings/slabs.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {
namespace {

using Edge = Segment2<Integer>;

/// Both rings in integers of one unit.
struct Rings {
  std::vector<Edge> a, b;
  Rational unit;
};

template <class Number>
void validate_simple(const char* field, const Polygon2<Number>& ring) {
  if (const auto defect = ring_defect(IntegerRing(ring))) validation::refuse(field, *defect, ring.size());
}

template <class Number>
Rings validated_polygon_polygon(const Polygon2<Number>& given_a, const Polygon2<Number>& given_b) {
  validation::validate_numbers("a", given_a), validation::validate_numbers("b", given_b);
  const validation::OpenRing open_a(given_a), open_b(given_b);
  const Polygon2<Number>&a = *open_a, &b = *open_b;
  validation::validate("a", given_a), validate_simple("a", a);
  validation::validate("b", given_b), validate_simple("b", b);
  Polygon2<Number> both = a;
  both.vertices.insert(both.vertices.end(), b.vertices.begin(), b.vertices.end());
  const IntegerRing integers(both);
  const auto edges = [&integers](std::size_t first, std::size_t size) {
    std::vector<Edge> made;
    for (std::size_t i = 0; i < size; ++i) made.push_back({integers[first + i], integers[first + (i + 1) % size]});
    return made;
  };
  return {edges(0, a.size()), edges(a.size(), b.size()), integers.unit};
}

template <class Number>
Truth<Contact> truth_of_polygon_polygon(const Polygon2<Number>& a, const Polygon2<Number>& b) {
  const Rings rings = validated_polygon_polygon(a, b);
  return contact_by_slabs(rings.a, rings.b, rings.unit);
}

}  // namespace

Truth<Contact> polygon_polygon(const Polygon2d& a, const Polygon2d& b) { return truth_of_polygon_polygon(a, b); }
Truth<Contact> polygon_polygon(const Polygon2<Rational>& a, const Polygon2<Rational>& b) {
  return truth_of_polygon_polygon(a, b);
}

}  // namespace touchstone::oracle
