// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/rings/whole.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// The rings of a region in integers, the outer one first, without positions that repeat the first.
using IntegerRegion = std::vector<Polygon2<Integer>>;
std::vector<Segment2<Integer>> edges_of(const IntegerRegion& region);

/// Regions of one question in integers of one unit, relative to an origin.
struct IntegerRegions {
  std::vector<IntegerRegion> regions;
  Rational unit;
};

/// The first defect by definition: edges of two rings have single points in common at most; by slabs, a hole is within
/// the outer ring, and no two holes have a common inside. nullopt: the rings fit together.
std::optional<validation::HoleDefect> hole_defect(const IntegerRegion& region);

/// Refuses the first region that breaks a rule; all numbers are finite.
template <Exact Number>
using NamedRegions = std::vector<std::pair<std::string, const Region2<Number>*>>;
template <Exact Number>
IntegerRegions validated_regions(const NamedRegions<Number>& regions, const Point2<Number>& origin);

}  // namespace touchstone::oracle
