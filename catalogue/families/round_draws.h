// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "catalogue/families/box_draws.h"
#include "catalogue/families/closest_draws.h"
#include "catalogue/families/obb_draws.h"
#include "geometry/capsules.h"
#include "geometry/polyhedra.h"

/// Hard cases of round convex solids, by the kinds of their cores.
namespace touchstone::catalogue {

using BallAndBox = std::tuple<Sphere3d, Obb3d>;
using CapsuleAndBox = std::tuple<Capsule3d, Obb3d>;
using CapsuleAndAabb = std::tuple<Capsule3d, Aabb3d>;

/// Half axes that lead along a displacement of integer length, or at right angles to it: the corner where all of them
/// end is the nearest to what is beyond it by that displacement, and so is each point of the edge or face that the
/// latter span.
struct BoxBehind {
  Obb3d box;
  Point3d nearest;
  Step step;
};
inline BoxBehind box_behind(DrawStream& c) {
  const Step step = integer_step(c);
  Obb3d box{lattice_point_in_space(c, 16), {}};
  Point3d nearest = box.center;
  for (Vector3d* axis : each_of(box.half_axes)) {
    const double k = up_to(c, 1), share = k == 0 ? small_integer(c, 2) : 2;
    *axis = 2 * k * step.displacement + 2.0 * lattice_across(c, step.displacement);
    nearest = nearest + share / 2 * *axis;
  }
  if (volume_of(box.half_axes) == 0) box.half_axes = straight_half_axes(c);
  return {box, nearest, step};
}
inline BallAndBox tangent_to_box(DrawStream& c) {
  const auto [box, nearest, step] = box_behind(c);
  return {{nearest + step.displacement, reaching(c, step.length)}, box};
}

/// Calls add(name, draw) for each.
template <class Add>
void add_balls_and_boxes(const Add& add) {
  add("tangent", [](DrawStream& c) -> BallAndBox { return tangent_to_box(c); });
  add("center_inside", [](DrawStream& c) -> BallAndBox {
    const Obb3d box = lattice_obb(c);
    const double r = up_to(c, 2);
    return {{in_obb(box, c), r}, box};
  });
  add("point_ball", [](DrawStream& c) -> BallAndBox {
    // In the box, on its boundary, or near it.
    const Obb3d box = lattice_obb(c);
    const Point3d p = c.coin() ? on_obb(box, c) : in_obb(box, c);
    const double aside = small_integer(c, 1);
    return {{{p.x + aside, p.y, p.z}, zero(c)}, box};
  });
  add("nearly_dependent", [](DrawStream& c) -> BallAndBox {
    const Obb3d box{lattice_point_in_space(c, 20), slanted_half_axes(c)};
    const Vector3d displacement = lattice_normal(c, 4);
    const double r = near_length(c, displacement);
    return {{on_obb(box, c) + displacement, r}, box};
  });
  add("dependent", [](DrawStream& c) -> BallAndBox {
    const Vector3d u = lattice_normal(c), v = lattice_normal(c);
    const double r = small_integer(c), s = small_integer(c);
    return {{lattice_point_in_space(c, 20), up_to(c, 2)}, {{0, 0, 0}, {u, r * u + s * v, v}}};
  });
  add("negative_radius", [](DrawStream& c) -> BallAndBox {
    const Obb3d box = lattice_obb(c);
    return {{lattice_point_in_space(c, 6), -one_to(c, 3)}, box};
  });
  add("near_root", [](DrawStream& c) -> BallAndBox {
    // The center is beyond an edge by (r, r), so its distance is r times the root of 2, which is irrational.
    const auto [x, r] = near_root(c);
    const double far = one_to(c, 8);
    return {{{r, r, integer(c, 10)}, x}, {{-far, -far, 0}, {{far, 0, 0}, {0, far, 0}, {0, 0, 4096}}}};
  });
  add("rounded_tangent", [](DrawStream& c) -> BallAndBox {
    const Obb3d box{ordinary_point_in_space(c), ordinary_half_axes(c)};
    const Point3d p = on_obb(box, c);
    const Vector3d displacement = ordinary_point_in_space(c) - Point3d{0, 0, 0};
    return {{p + displacement, near_length(c, displacement)}, box};
  });
  add("long_and_thin", [](DrawStream& c) -> BallAndBox {
    const Obb3d box = long_and_thin_obb(c);
    const Point3d p = on_obb(box, c);
    return {{p, c.coin() ? 0.0 : scaled_down(c, 4, 1070)}, box};
  });
  add("stretched", [](DrawStream& c) -> BallAndBox {
    auto [ball, box] = tangent_to_box(c);
    Stretch{c}(ball.center, box);
    return {ball, box};
  });
  add("subnormal", [](DrawStream& c) -> BallAndBox {
    // Integers times the least number, or a few times that: their products underflow.
    auto [ball, box] = tangent_to_box(c);
    const int down = -1074 + integer_in(c, 0, 60);
    change_each(box, [down](auto& v) { v = scaled(v, down); });
    return {{scaled(ball.center, down), std::ldexp(ball.radius, down)}, box};
  });
  add("moderate_ends", [](DrawStream& c) -> BallAndBox {
    // The greatest and the least numbers that the filter takes, and the next beyond them; tangent, or far from that.
    const double large = power_of_two(c, 29, 31), least = power_of_two(c, -32, -29), side = small_integer(c, 1);
    const double far = c.coin() ? 0 : large / 2, r = c.coin() ? least : large;
    return {{{large + far + least, side * least, 0}, r}, {{0, 0, 0}, {{large, 0, 0}, {0, large, 0}, {0, least, 1}}}};
  });
  add("whole_range", [](DrawStream& c) -> BallAndBox {
    const Point3d p = point_of_full_range(c), center = point_of_full_range(c);
    const double r = std::fabs(of_full_range(c)), far = of_full_range(c), x = huge(c), y = huge(c);
    return {{p, r}, {center, {{x, 0, 0}, {far, y, 0}, {0, far, 1}}}};
  });
  add("either_zero", [](DrawStream& c) -> BallAndBox {
    const Obb3d box{zero_point(c), {{1, zero(c), zero(c)}, {zero(c), -1, zero(c)}, {zero(c), zero(c), 1}}};
    const double x = small_integer(c, 2), r = c.coin() ? -0.0 : up_to(c, 1);
    return {{{x == 0 ? zero(c) : x, zero(c), zero(c)}, r}, box};
  });
  add("typed_touch", [](DrawStream& c) -> BallAndBox {
    // As typed the ball reaches a face of a box that is turned by the triple 3, 4, 5.
    const double k = one_to(c, 9), m = one_to(c, 9);
    return {{{3 * (k + m) / 10, 4 * (k + m) / 10, 0}, 5 * m / 10},
            {{0, 0, 0}, {{3 * k / 10, 4 * k / 10, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}}};
  });
}

inline const Point3d& a_point_of(const Obb3d& box) { return box.center; }
inline const Point3d& a_point_of(const Triangle3d& triangle) { return triangle.a; }
inline const Point3d& a_point_of(const Meshd& mesh) { return mesh.vertices[0]; }

/// A capsule that ends in the ball: of one point, or leading away from a point of the other solid, through it, or
/// anywhere.
template <class Solid>
std::tuple<Capsule3d, Solid> ending_in(const std::tuple<Sphere3d, Solid>& drawn, DrawStream& c) {
  const auto& [ball, solid] = drawn;
  const Point3d end = ball.center;
  Point3d other = end;
  switch (c.below(4)) {
    case 0: break;
    case 1: other = along(end, one_to(c, 2), end - a_point_of(solid)); break;
    case 2: other = along(end, -one_to(c, 2), end - a_point_of(solid)); break;
    default: other = end + lattice_normal(c, 4);
  }
  return {{c.coin() ? Segment3d{other, end} : Segment3d{end, other}, ball.radius}, solid};
}

/// Calls add(name, draw) for each.
template <class Add>
void add_capsules_and_boxes(const Add& add) {
  add("tangent_along", [](DrawStream& c) -> CapsuleAndBox {
    // Along a face or an edge, or across an edge.
    const auto [box, nearest, step] = box_behind(c);
    const Point3d over = nearest + step.displacement;
    const Vector3d v = lattice_across(c, step.displacement);
    const double i = small_integer(c, 2), j = small_integer(c, 2);
    return {{{along(over, i, v), along(over, j, v)}, reaching(c, step.length)}, box};
  });
  add("crossing", [](DrawStream& c) -> CapsuleAndBox {
    const Obb3d box = lattice_obb(c);
    const Point3d p = in_obb(box, c);
    const Segment3d segment = segment_through(c, p, lattice_normal(c, 12));
    return {{segment, up_to(c, 1)}, box};
  });
  add("segment_on_boundary", [](DrawStream& c) -> CapsuleAndBox {
    // It has a point of the boundary, or two.
    const Obb3d box = lattice_obb(c);
    const Point3d p = on_obb(box, c);
    const Segment3d segment = c.coin() ? Segment3d{p, on_obb(box, c)} : segment_through(c, p, lattice_normal(c, 4));
    return {{segment, zero(c)}, box};
  });
  add_balls_and_boxes([&add]<class Draw>(const char* family, const Draw&) {
    add(family, [](DrawStream& c) -> CapsuleAndBox { return ending_in(Draw()(c), c); });
  });
}

/// A box, and what is beyond it by a step that is an integer long: beyond a face, an edge or a corner, as the step has
/// one, two or three coordinates that are not 0.
struct BeyondAabb {
  Aabb3d box;
  Point3d place;
  Vector3d out;
  double length;
};
inline BeyondAabb beyond_aabb(DrawStream& c) {
  const Step step = integer_step(c);
  const Aabb3d box = lattice_box(c);
  const Point3d beside = within(box, c).min;
  BeyondAabb found{box, beside, step.displacement, step.length};
  const auto move = [&c](double& place, double& out, double min, double max) {
    if (out == 0) return;
    const bool below = c.coin();
    out = below ? -std::fabs(out) : std::fabs(out);
    place = (below ? min : max) + out;
  };
  move(found.place.x, found.out.x, box.min.x, box.max.x), move(found.place.y, found.out.y, box.min.y, box.max.y);
  move(found.place.z, found.out.z, box.min.z, box.max.z);
  return found;
}

/// A capsule that is tangent to a box, or nearly: one end is the nearest, or all of it, or a point between.
inline CapsuleAndAabb tangent_to_aabb(DrawStream& c) {
  const auto [box, place, out, length] = beyond_aabb(c);
  const double away = up_to(c, 1), i = small_integer(c, 2), j = small_integer(c, 2);
  const Vector3d v = lattice_across(c, out);
  return {{{along(place, i, v), along(along(place, j, v), away, out)}, reaching(c, length)}, box};
}

inline Aabb3d flattened(Aabb3d box, DrawStream& c) {
  const bool x = c.coin(), y = c.coin();
  if (x) box.max.x = box.min.x;
  if (y) box.max.y = box.min.y;
  if ((!x && !y) || c.coin()) box.max.z = box.min.z;
  return box;
}

/// Calls add(name, draw) for each.
template <class Add>
void add_capsules_and_aabbs(const Add& add) {
  add("tangent", [](DrawStream& c) -> CapsuleAndAabb { return tangent_to_aabb(c); });
  add("crossing", [](DrawStream& c) -> CapsuleAndAabb {
    const Aabb3d box = lattice_box(c);
    const Point3d p = within(box, c).min;
    const Segment3d segment = segment_through(c, p, lattice_normal(c, 12));
    return {{segment, up_to(c, 1)}, box};
  });
  add("end_inside", [](DrawStream& c) -> CapsuleAndAabb {
    const Aabb3d box = lattice_box(c);
    const Point3d p = within(box, c).max, q = c.coin() ? within(box, c).min : lattice_point_of_box(c);
    return {{{p, q}, up_to(c, 3)}, box};
  });
  add("no_radius", [](DrawStream& c) -> CapsuleAndAabb {
    // It ends on the boundary, or passes through a corner or an edge.
    const Aabb3d box = lattice_box(c);
    Point3d p = within(box, c).min;
    p.x = c.coin() ? box.min.x : box.max.x;
    if (c.coin()) p.y = box.max.y;
    const Segment3d segment = segment_through(c, p, lattice_normal(c, 4));
    return {{segment, zero(c)}, box};
  });
  add("flat", [](DrawStream& c) -> CapsuleAndAabb {
    // A rectangle, a segment or a point, tangent or met.
    auto [capsule, box] = tangent_to_aabb(c);
    const Aabb3d thin = flattened(box, c);
    if (c.coin()) capsule.segment.a = within(thin, c).min;
    return {capsule, thin};
  });
  add("flat_crossing", [](DrawStream& c) -> CapsuleAndAabb {
    const Aabb3d box = flattened(lattice_box(c), c);
    const Point3d p = within(box, c).min;
    const Segment3d segment = segment_through(c, p, lattice_normal(c, 4));
    const double r = up_to(c, 1), aside = small_integer(c, 1);
    return {{{segment.a, along(segment.b, aside, {0, 0, 1})}, r}, box};
  });
  add("min_beyond_max", [](DrawStream& c) -> CapsuleAndAabb {
    auto [capsule, box] = tangent_to_aabb(c);
    (c.coin() ? box.max.z : box.max.x) -= one_to(c, 300);
    return {capsule, box};
  });
  add("near_root", [](DrawStream& c) -> CapsuleAndAabb {
    // An end is beyond an edge by (r, r), so its distance is r times the root of 2, which is irrational.
    const auto [x, r] = near_root(c);
    const double z = integer(c, 10), k = up_to(c, 2), far = one_to(c, 8);
    return {{{{r + k * r, r + k * r, z}, {r, r, z}}, x}, {{-far, -far, -4096}, {0, 0, 4096}}};
  });
  add("rounded_tangent", [](DrawStream& c) -> CapsuleAndAabb {
    const Point3d corner = ordinary_point_in_space(c), least = corner + Vector3d{-1, -1, -1};
    const double x = std::fabs(ordinary(c)), y = std::fabs(ordinary(c)), z = c.coin() ? std::fabs(ordinary(c)) : 0.0;
    const Vector3d out{x, y, z};
    return {{{corner + out, along(corner, up_to(c, 3), out)}, near_length(c, out)}, {least, corner}};
  });
  add("of_each_size", [](DrawStream& c) -> CapsuleAndAabb {
    // Each width and the segment of its own size, from one end of the range to the other.
    const double x = scaled_up(c, 4, 1000), y = scaled_down(c, 4, 1070), z = scaled_down(c, 4, 1070);
    const Point3d p{small_integer(c, 1) * x, y, z}, q{scaled_up(c, 4, 1000), small_integer(c, 1) * y, 0};
    return {{{p, q}, c.coin() ? 0.0 : scaled_down(c, 4, 1070)}, {{0, 0, 0}, {x, y, z}}};
  });
  add("subnormal", [](DrawStream& c) -> CapsuleAndAabb {
    // Integers times the least number, or a few times that: their products underflow.
    auto [capsule, box] = tangent_to_aabb(c);
    const int down = -1074 + integer_in(c, 0, 60);
    return {{{scaled(capsule.segment.a, down), scaled(capsule.segment.b, down)}, std::ldexp(capsule.radius, down)},
            {scaled(box.min, down), scaled(box.max, down)}};
  });
  add("moderate_ends", [](DrawStream& c) -> CapsuleAndAabb {
    // The greatest and the least numbers that the filter takes, and the next beyond them; tangent, or far from that.
    const double large = power_of_two(c, 29, 31), least = power_of_two(c, -32, -29), side = small_integer(c, 1);
    const double far = c.coin() ? 0 : large / 2, r = c.coin() ? least : large;
    return {{{{large + far + least, side * least, 0}, {2 * large, far, 0}}, r}, {{-large, 0, 0}, {large, least, 1}}};
  });
  add("whole_range", [](DrawStream& c) -> CapsuleAndAabb {
    const Point3d p = point_of_full_range(c), q = point_of_full_range(c);
    const double r = std::fabs(of_full_range(c));
    return {{{p, q}, r}, box_of(c, of_full_range)};
  });
  add("either_zero", [](DrawStream& c) -> CapsuleAndAabb {
    const Point3d p = zero_point(c), q = zero_point(c), low = zero_point(c), high = zero_point(c);
    const double x = small_integer(c, 2), r = c.coin() ? -0.0 : up_to(c, 1);
    return {{{{x, p.y, p.z}, q}, r}, {low, c.coin() ? high : Point3d{1, 1, 1}}};
  });
  add("typed_touch", [](DrawStream& c) -> CapsuleAndAabb {
    // As typed an end reaches the edge.
    const double k = one_to(c, 9), m = one_to(c, 9), far = up_to(c, 9) / 10;
    return {{{{(m + 3 * k) / 10, (m + 4 * k) / 10, 0}, {2, 2, far}}, 5 * k / 10}, {{-1, -1, -1}, {m / 10, m / 10, 1}}};
  });
}

}  // namespace touchstone::catalogue
