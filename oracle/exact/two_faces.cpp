// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/two_faces.h"

#include <algorithm>
#include <vector>

#include "oracle/exact/linear_program.h"

namespace touchstone::oracle {
namespace {

using Program = LinearProgram<Integer>;
using Corners = std::array<Index, 3>;

Corners corners_of(const Face& f) { return {f.a, f.b, f.c}; }

bool has(const Corners& corners, Index vertex) {
  return std::find(corners.begin(), corners.end(), vertex) != corners.end();
}

/// A row of the program: a corner, on which side of the plane it has to be (0: on it), and its place in its face.
struct Demand {
  Index vertex;
  int side;
  std::size_t place;
};

std::vector<Demand> demands_of(const Corners& first, const Corners& second) {
  std::vector<Demand> demands;
  for (std::size_t k = 0; k < 3; ++k) demands.push_back({first[k], has(second, first[k]) ? 0 : -1, k});
  for (std::size_t k = 0; k < 3; ++k)
    if (!has(first, second[k])) demands.push_back({second[k], 1, k});
  return demands;
}

bool beside(const WholeCloud& cloud, const Corners& plane, const Corners& other) {
  const SupportingPlane of_face = cloud.plane(cloud.normal(plane[0], plane[1], plane[2]), plane[0]);
  int side = 0;
  for (const Index v : other) {
    if (has(plane, v)) continue;
    const int here = sgn(cloud.height(of_face, v));
    if (here == 0 || here == -side) return false;
    side = here;
  }
  return side != 0;
}

/// A plane across an axis has f below or on it and g above or on it, and on it, of one of them, only common corners.
bool across_an_axis(const WholeCloud& cloud, const Corners& f, const Corners& g) {
  for (Integer Point3<Integer>::*axis : {&Point3<Integer>::x, &Point3<Integer>::y, &Point3<Integer>::z}) {
    const auto at = [&](Index v) -> const Integer& { return cloud[v].*axis; };
    const Integer top = std::max({at(f[0]), at(f[1]), at(f[2])}), bottom = std::min({at(g[0]), at(g[1]), at(g[2])});
    const auto only_common = [&](const Corners& face, const Corners& other) {
      return std::all_of(face.begin(), face.end(), [&](Index v) { return at(v) != top || has(other, v); });
    };
    if (top < bottom || (top == bottom && (only_common(f, g) || only_common(g, f)))) return true;
  }
  return false;
}

}  // namespace

/// Variables: normal and offset, each as a difference of two, from the first corner as origin. side * (normal . p -
/// offset) >= 1, or = 0 where the corner is common.
TwoFaces::TwoFaces(const WholeCloud& cloud, const Face& f, const Face& g) {
  const Corners first = corners_of(f), second = corners_of(g);
  const std::vector<Demand> demands = demands_of(first, second);
  if (demands.size() == 3) {
    meet = true, on_first[0] = 1;
    on_second[static_cast<std::size_t>(std::find(second.begin(), second.end(), first[0]) - second.begin())] = 1;
    return;
  }
  std::vector<Program::Row> rows;
  for (const Demand& demand : demands) rows.push_back(demand.side == 0 ? Program::Row::equal : Program::Row::at_most);
  Program program(8, rows);
  for (int row = 0; row < static_cast<int>(demands.size()); ++row) {
    const Demand& demand = demands[static_cast<std::size_t>(row)];
    const int sign = demand.side == 0 ? 1 : -demand.side;
    const Vector3<Integer> p = cloud.between(first[0], demand.vertex);
    const std::array<Integer, 4> terms{Integer(sign * p.x), Integer(sign * p.y), Integer(sign * p.z), Integer(-sign)};
    for (int i = 0; i < 4; ++i) {
      program.set_coefficient(row, 2 * i, terms[static_cast<std::size_t>(i)]);
      program.set_coefficient(row, 2 * i + 1, Integer(-terms[static_cast<std::size_t>(i)]));
    }
    if (demand.side != 0) program.set_right_side(row, -1);
  }
  meet = !program.feasible();
  if (!meet) {
    const auto number = [&program](int i) { return Integer(program.numerator(2 * i) - program.numerator(2 * i + 1)); };
    normal = WitnessPlane::of({number(0), number(1), number(2)}, 0).normal;
    return;
  }
  Rational sum;
  for (std::size_t row = 0; row < demands.size(); ++row) {
    const Integer& y = program.farkas()[row];
    const auto [vertex, side, place] = demands[row];
    if (side < 0 || (side == 0 && sgn(y) > 0)) {
      on_first[place] = Rational(y), sum += on_first[place];
    } else if (side > 0) {
      on_second[place] = Rational(y);
    } else {
      on_second[static_cast<std::size_t>(std::find(second.begin(), second.end(), vertex) - second.begin())] =
          Rational(Integer(-y));
    }
  }
  for (auto* weights : {&on_first, &on_second})
    for (Rational& weight : *weights) weight /= sum;
}

bool boxes_apart(const WholeCloud& cloud, const Face& first, const Face& second) {
  for (Integer Point3<Integer>::*axis : {&Point3<Integer>::x, &Point3<Integer>::y, &Point3<Integer>::z}) {
    const auto ends = [&](const Face& f) {
      return std::minmax({cloud[f.a].*axis, cloud[f.b].*axis, cloud[f.c].*axis});
    };
    const auto [low, high] = ends(first);
    const auto [other_low, other_high] = ends(second);
    if (high < other_low || other_high < low) return true;
  }
  return false;
}

bool plainly_apart(const WholeCloud& cloud, const Face& first, const Face& second) {
  const Corners f = corners_of(first), g = corners_of(second);
  return across_an_axis(cloud, f, g) || across_an_axis(cloud, g, f) || beside(cloud, f, g) || beside(cloud, g, f);
}

}  // namespace touchstone::oracle
