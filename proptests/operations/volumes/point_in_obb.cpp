// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/point_in_obb.h"

#include "proptests/forward_error.h"
#include "proptests/laws.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"

namespace touchstone::proptests::point_in_obb_tests {
namespace {

using Row = rows::point_in_obb;

constexpr Location inside = Location::inside, boundary = Location::boundary, outside = Location::outside;
constexpr Obb3d cube{{0, 0, 0}, {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
/// Half as high over the square of the cube, sheared by as much: v leans over u.
constexpr Obb3d sheared{{0, 0, 0}, {{2, 0, 0}, {2, 2, 0}, {0, 0, 1}}};
/// Turned by the triple 3, 4, 5.
constexpr Obb3d turned{{10, 0, 0}, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}};

constexpr Worked<Row> worked;

Vector3d reversed_axis(const Vector3d& v) { return {-v.x, -v.y, -v.z}; }

/// Twelve triangles; vertex number 4 r + 2 s + t.
Meshd mesh_of(const Obb3d& box) {
  Meshd mesh;
  for (const double r : {-2.0, 2.0})
    for (const double s : {-2.0, 2.0})
      for (const double t : {-2.0, 2.0}) mesh.vertices.push_back(catalogue::halves_along(box, r, s, t));
  for (const auto& [a, b, c, d] :
       {std::array<Index, 4>{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
  }
  return mesh;
}

/// The two sides of the slide's comparison for a half axis, and what they may be off by.
struct Projection {
  Rational along, reach, error;
  bool overflow;

  Projection(const Vector3d& displacement, const Vector3<Rational>& d, const Vector3d& a) {
    const Rational u = unit(), x = d.x * exact(a.x), y = d.y * exact(a.y), z = d.z * exact(a.z);
    along = abs(Rational(x + y + z));
    reach = exact(a.x) * exact(a.x) + exact(a.y) * exact(a.y) + exact(a.z) * exact(a.z);
    error = (4 + 7 * u) * u * (abs(x) + abs(y) + abs(z)) + (3 + 4 * u) * u * reach + power_of_two(-1072);
    overflow = !finite(dot(displacement, a), dot(a, a), std::fabs(dot(displacement, a)) - dot(a, a));
  }
  bool certain() const { return !overflow && abs(Rational(along - reach)) > error; }
};

bool orthogonal(const Vector3d& v, const Vector3d& w) {
  return exact(v.x) * exact(w.x) + exact(v.y) * exact(w.y) + exact(v.z) * exact(w.z) == 0;
}

}  // namespace

LAW("point_in_obb: half axes may be exchanged and reversed", box, p) {
  const auto& [u, v, w] = box.half_axes;
  const Location location = ask(asked);
  return ask(Row::Question{{box.center, {v, u, w}}, p}) == location &&
         ask(Row::Question{{box.center, {w, reversed_axis(u), v}}, p}) == location &&
         ask(Row::Question{{box.center, {reversed_axis(u), reversed_axis(v), reversed_axis(w)}}, p}) == location;
}

LAW("point_in_obb: the center is inside, and what is opposite to a point lies as the point does", box, p) {
  const Point3d& c = box.center;
  if (ask(Row::Question{box, c}) != inside) return false;
  return !on_lattice(asked) ||
         ask(Row::Question{box, {c.x + (c.x - p.x), c.y + (c.y - p.y), c.z + (c.z - p.z)}}) == ask(asked);
}

LAW("point_in_obb: ends of half axes and corners are on the boundary, and beyond is outside", box) {
  if (!on_lattice(asked)) return true;
  const auto at = [&](double r, double s, double t) {
    return ask(Row::Question{box, catalogue::halves_along(box, 2 * r, 2 * s, 2 * t)});
  };
  return at(1, 0, 0) == boundary && at(0, -1, 0) == boundary && at(0, 0, 1) == boundary && at(1, -1, 1) == boundary &&
         at(2, 0, 0) == outside && at(0, 0, -2) == outside && at(1, 1, 2) == outside;
}

TEST_CASE("point_in_obb: a box is the convex polyhedron of its corners") {
  robust_law<Row>(
      "as a mesh",
      [](const auto& ask, const auto& asked) {
        const auto& [box, p] = asked;
        return !on_lattice(asked) || robust::point_in_convex_polyhedron(mesh_of(box), p) == ask(asked);
      },
      3);
}

TEST_CASE("point_in_obb: p. 27's boxes worked by hand") {
  worked({cube, {1, 0, -1}}, inside, 1);  // x: 2 - 1
  worked({cube, {0, 0, 0}}, inside, 4);
  worked({cube, {2, 1, 0}}, boundary, 0);
  worked({cube, {-2, 2, 0}}, boundary, 0);
  worked({cube, {2, -2, 2}}, boundary, 0);
  worked({cube, {3, 0, 5}}, outside, 9);  // z: 5 - 2
  worked({cube, {2, 0, -3}}, outside, 1);
  // The sides' planes are 3 x + 4 y = 30 +- 25 and -4 x + 3 y = -40 +- 25, of normals of length 5.
  worked({turned, {11, 2, 0}}, inside, Rational(14 * 14, 25));  // 41 - 55; the other way 2
  worked({turned, {9, 7, 3}}, boundary, 0);                     // 55; -15
  worked({turned, {14, 3, 0}}, inside, Rational(1, 25));        // 54; -47
  worked({turned, {14, 4, 0}}, outside, Rational(9, 25));       // 58; -44
}

TEST_CASE("point_in_obb: where half axes are not at right angles the projections answer for another box") {
  // y between -2 and 2, x - y between -2 and 2, z between -1 and 1.
  worked({sheared, {3, 2, 0}}, boundary, 0, "algorithm");             // d . v = 10, v . v = 8
  worked({sheared, {2, 1, 0}}, inside, Rational(1, 2), "algorithm");  // d . u = 4 = u . u
  worked({sheared, {1, -1.5, 0}}, outside, Rational(1, 8), "algorithm");
  worked({sheared, {1, 1, 0.5}}, inside, Rational(1, 4));
  worked({sheared, {4, 2, 1}}, boundary, 0, "algorithm");
  worked({sheared, {0, 0, 1}}, boundary, 0);
  worked({sheared, {9, 0, 0}}, outside, Rational(49, 2));
}

TEST_CASE("point_in_obb: rounding, huge, subnormal and negative zero") {
  const Obb3d least{{0, 0, 0}, {{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}};
  const Rational t = exact(tiny);
  worked({least, {tiny, tiny, 0}}, boundary, 0);
  worked({least, {0, 0, 0}}, inside, Rational(t * t), "rounding");
  worked({least, {2 * tiny, 0, 0}}, outside, Rational(t * t), "rounding");
  const Obb3d large{{-huge, 0, 0}, {{huge, 0, 0}, {0, huge, 0}, {0, 0, 1}}};
  worked({large, {0, 0, 0}}, boundary, 0);
  worked({large, {huge, 0, 0}}, outside, Rational(exact(huge) * exact(huge)), "rounding");
  worked({large, {-huge, 1, 0}}, inside, 1);
  worked({{{-0.0, 0, 0}, {{1, -0.0, 0}, {0, -1, -0.0}, {0, 0, 1}}}, {-1, -0.0, 0}}, boundary, 0);
  // As doubles, 0.1 + 0.2 is 2^-55 more than 0.3.
  worked({{{0.1, 0, 0}, {{0.2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0.3, 0, 0}}, inside, power_of_two(-110));
}

TEST_CASE("point_in_obb: half axes in one plane are refused") {
  const auto of = [](const Vector3d& u, const Vector3d& v, const Vector3d& w) { return Obb3d{{0, 0, 0}, {u, v, w}}; };
  refused<Row>({of({1, 2, 3}, {4, 5, 6}, {7, 8, 9}), {0, 0, 0}}, "obb.half_axes", "linearly independent");
}

CONTRACT("point_in_obb: the formula in double is that in exact arithmetic where the bound of its contract says so", box,
         p) {
  const auto& [u, v, w] = box.half_axes;
  const Point3d& c = box.center;
  const Vector3<Rational> d{Rational(exact(p.x) - exact(c.x)), Rational(exact(p.y) - exact(c.y)),
                            Rational(exact(p.z) - exact(c.z))};
  bool beyond = false;
  for (const Vector3d* a : {&u, &v, &w}) {
    const Projection projection(p - c, d, *a);
    if (!projection.certain()) return true;
    beyond = beyond || projection.along > projection.reach;
  }
  if (answer != (beyond ? outside : inside)) return false;
  return answer == truth.answer || !(orthogonal(u, v) && orthogonal(v, w) && orthogonal(w, u));
}

}  // namespace touchstone::proptests::point_in_obb_tests
