// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/two_faces.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

using Program = LinearProgram<Integer>;
using FaceCorners = std::array<Index, 3>;

FaceCorners corners_of(const Face& f) { return {f.a, f.b, f.c}; }

bool has(const FaceCorners& corners, Index vertex) {
  return std::find(corners.begin(), corners.end(), vertex) != corners.end();
}

/// A row of the program: a corner, the side of the plane on which it must be (0: on it), and its index in its face.
struct Demand {
  Index vertex;
  int side;
  std::size_t place;
};

std::vector<Demand> demands_of(const FaceCorners& first, const FaceCorners& second) {
  std::vector<Demand> demands;
  for (std::size_t k = 0; k < 3; ++k) demands.push_back({first[k], has(second, first[k]) ? 0 : -1, k});
  for (std::size_t k = 0; k < 3; ++k)
    if (!has(first, second[k])) demands.push_back({second[k], 1, k});
  return demands;
}

bool beside(const IntegerCloud& cloud, const FaceCorners& plane, const FaceCorners& other) {
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

/// True if a plane has f below or on it and g above or on it, and one of them has only common corners on it. at: the
/// height of a vertex.
template <class Height>
bool held_apart(const Height& at, const FaceCorners& f, const FaceCorners& g) {
  const Integer top = std::max({Integer(at(f[0])), Integer(at(f[1])), Integer(at(f[2]))}),
                bottom = std::min({Integer(at(g[0])), Integer(at(g[1])), Integer(at(g[2]))});
  const auto only_common = [&](const FaceCorners& face, const FaceCorners& other) {
    return std::all_of(face.begin(), face.end(), [&](Index v) { return at(v) != top || has(other, v); });
  };
  return top < bottom || (top == bottom && (only_common(f, g) || only_common(g, f)));
}

bool across_an_axis(const IntegerCloud& cloud, const FaceCorners& f, const FaceCorners& g) {
  for (Integer Point3<Integer>::*axis : {&Point3<Integer>::x, &Point3<Integer>::y, &Point3<Integer>::z})
    if (held_apart([&](Index v) -> const Integer& { return cloud[v].*axis; }, f, g)) return true;
  return false;
}

/// The outward normals of the planes through the edges of f, perpendicular to it: returns that of a plane with f below
/// and g above.
std::optional<Vector3<Integer>> upright_between(const IntegerCloud& cloud, const FaceCorners& f, const FaceCorners& g) {
  const Vector3<Integer> upwards = cloud.normal(f[0], f[1], f[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3<Integer> outwards = cross(cloud.between(f[k], f[(k + 1) % 3]), upwards);
    if (held_apart([&](Index v) { return cloud.along(outwards, v); }, f, g)) return outwards;
  }
  return std::nullopt;
}

}  // namespace

/// Variables: normal and offset, each as a difference of two, relative to the first corner. side * (normal . p -
/// offset) >= 1, or = 0 if the corner is common.
TwoFaces::TwoFaces(const IntegerCloud& cloud, const Face& f, const Face& g) {
  const FaceCorners first = corners_of(f), second = corners_of(g);
  const std::vector<Demand> demands = demands_of(first, second);
  if (demands.size() == 3) {
    meet = true, on_first[0] = 1;
    on_second[static_cast<std::size_t>(std::find(second.begin(), second.end(), first[0]) - second.begin())] = 1;
    return;
  }
  const auto smallest = [](const Vector3<Integer>& n) { return WitnessPlane::of(n, 0).normal; };
  if (const auto of_first = upright_between(cloud, first, second)) {
    normal = smallest(*of_first);
    return;
  }
  if (const auto of_second = upright_between(cloud, second, first)) {
    normal = smallest(Integer(-1) * *of_second);
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
    normal = smallest({number(0), number(1), number(2)});
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

bool plainly_apart(const IntegerCloud& cloud, const Face& first, const Face& second) {
  const FaceCorners f = corners_of(first), g = corners_of(second);
  if (std::all_of(f.begin(), f.end(), [&g](Index v) { return has(g, v); })) return false;
  return across_an_axis(cloud, f, g) || across_an_axis(cloud, g, f) || beside(cloud, f, g) || beside(cloud, g, f);
}

}  // namespace touchstone::oracle
