// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/answers.h"
#include "oracle/exact/shapes/nearest_pair.h"

namespace touchstone::oracle {

/// The contact of two shapes, one or both of them grown by a radius; `radii` lists the radii. They have a common point
/// exactly if the distance is at most the sum of the radii, and a common interior point, or an interior point of the
/// only solid in the other shape, exactly if it is less and no radius is 0.
///
/// Margin: in squares, the difference of the distance and that sum; if they meet, and a radius becomes 0, the decrease
/// of the sum, if that is less.
///
/// Certificate, with the weights of the nearest points as facts: disjoint: "nearest_points". touching: "tangent", or
/// "no_interior", if a radius is 0 and they are nearer. overlapping: "near_points".
Truth<Contact> contact_of_nearest(const Rational& squared_distance, const std::vector<Rational>& radii,
                                  std::vector<std::pair<std::string, std::vector<Rational>>> weights);

}  // namespace touchstone::oracle
