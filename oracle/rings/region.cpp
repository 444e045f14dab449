// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/region.h"

#include <algorithm>

#include "oracle/exact/systems/elimination.h"
#include "oracle/rings/simple.h"
#include "oracle/rings/slabs.h"

namespace touchstone::oracle {
namespace {

using Edges = std::vector<Segment2<Integer>>;

Edges edges_of(const Polygon2<Integer>& ring) {
  Edges edges;
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring.next(i)});
  return edges;
}

/// Two edges have a piece in common.
bool share_a_piece(const Edges& a, const Edges& b) {
  return std::any_of(a.begin(), a.end(), [&b](const auto& e) {
    return std::any_of(b.begin(), b.end(), [&e](const auto& f) {
      return segment_segment_relation<Integer>(e, f) == SegmentRelation::overlap;
    });
  });
}

/// The rings without positions that repeat the first.
template <class Number>
std::vector<Polygon2<Number>> rings_of(const Region2<Number>& region) {
  std::vector<Polygon2<Number>> rings{*validation::OpenRing(region.outer)};
  for (const auto& hole : region.holes) rings.push_back(*validation::OpenRing(hole));
  return rings;
}

template <class Number>
IntegerRegions integers_of(const NamedRegions<Number>& regions, const Point2<Number>& origin) {
  Polygon2<Number> all{{origin}};
  for (const auto& named : regions)
    for (const auto& ring : rings_of(*named.second))
      all.vertices.insert(all.vertices.end(), ring.vertices.begin(), ring.vertices.end());
  const IntegerRing integers(all);
  IntegerRegions found{{}, integers.unit};
  std::size_t next = 1;
  for (const auto& named : regions) {
    IntegerRegion region;
    for (const auto& ring : rings_of(*named.second)) {
      region.emplace_back();
      for (std::size_t i = 0; i < ring.size(); ++i, ++next)
        region.back().vertices.push_back(
            {Integer(integers[next].x - integers[0].x), Integer(integers[next].y - integers[0].y)});
    }
    found.regions.push_back(std::move(region));
  }
  return found;
}

template <class Number>
void validate_simple(const std::string& field, const Polygon2<Number>& ring) {
  if (const auto defect = ring_defect(IntegerRing(ring))) validation::refuse(field, *defect, ring.size());
}

}  // namespace

Edges edges_of(const IntegerRegion& region) {
  Edges edges;
  for (const auto& ring : region) {
    const Edges own = edges_of(ring);
    edges.insert(edges.end(), own.begin(), own.end());
  }
  return edges;
}

std::optional<validation::HoleDefect> hole_defect(const IntegerRegion& region) {
  for (std::size_t i = 1; i < region.size(); ++i) {
    const Edges hole = edges_of(region[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const Edges other = edges_of(region[j]);
      const auto cuts = arrangement_of(other, hole).cuts;
      const bool fit = j == 0 ? covers(other, hole, cuts) : !common_interior_point(other, hole, cuts);
      if (!fit || share_a_piece(other, hole)) return validation::HoleDefect{i - 1, j == 0 ? i - 1 : j - 1};
    }
  }
  return std::nullopt;
}

template <Exact Number>
IntegerRegions validated_regions(const NamedRegions<Number>& regions, const Point2<Number>& origin) {
  for (const auto& named : regions) {
    const auto& [field, region] = named;
    validation::validate(field, *region);
    const auto rings = rings_of(*region);
    validate_simple(field + ".outer", rings[0]);
    for (std::size_t i = 1; i < rings.size(); ++i)
      validate_simple(validation::named(field, {"holes", i - 1}), rings[i]);
    const IntegerRegion integers = std::move(integers_of<Number>({named}, origin).regions[0]);
    if (const auto defect = hole_defect(integers)) validation::refuse(field, *defect);
  }
  return integers_of(regions, origin);
}
template IntegerRegions validated_regions(const NamedRegions<double>&, const Point2d&);
template IntegerRegions validated_regions(const NamedRegions<Rational>&, const Point2<Rational>&);

}  // namespace touchstone::oracle
