// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/box_draws.h"
#include "catalogue/families/closest_draws.h"
#include "catalogue/families/edge_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/triangle_aabb.h"
#include "oracle/mixed/triangle_aabb.h"
#include "reference/mixed/triangle_aabb.h"
#include "reference/standard/triangle_in_box.h"
#include "robust/mixed/triangle_aabb.h"

namespace touchstone::catalogue::rows {

struct triangle_aabb : signatures::triangle_aabb {
  TOUCHSTONE_STAGED_MODULES(triangle_aabb)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "21, 27, 45-47, 54",
      .question = "Do a triangle and an axis-aligned box overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"triangle", "aabb"},
      .answer = "contact",
      .margin_degree = 1};

  static void standard(const auto& add) {
    add("Akenine-Moeller, seen from the box's center",
        [](const auto&... q) { return ::touchstone::reference::standard::triangle_aabb(q...); });
  }

  static void hard_cases(HardCases<Question>& add) {
    add("corner_on_boundary", [](DrawStream& c) -> Question {
      const Touch touch = Touch::of(c);
      return touch.question(c, {touch.at, touch.above(c), touch.above(c)});
    });
    add("edge_on_boundary", [](DrawStream& c) -> Question {
      const Touch touch = Touch::of(c);
      const Vector3d displacement = lattice_across(c, touch.normal);
      return touch.question(c, {along(touch.at, -up_to(c, 2), displacement),
                                along(touch.at, one_to(c, 3), displacement), touch.above(c)});
    });
    add("triangle_on_boundary", [](DrawStream& c) -> Question {
      const Touch touch = Touch::of(c);
      const Vector3d u = lattice_across(c, touch.normal), v = lattice_across(c, touch.normal);
      return touch.question(c, {touch.at + u, touch.at + v, along(along(touch.at, -1, u), -1, v)});
    });
    add("in_plane_through_corner", [](DrawStream& c) -> Question {
      const Touch touch = Touch::of(c);
      const LatticePlane plane{touch.at, lattice_across(c, touch.normal), lattice_across(c, touch.normal)};
      return touch.question(c, plane.triangle(c));
    });
    add("past_corner", [](DrawStream& c) -> Question {
      // So large that nothing but its plane keeps them apart.
      const Touch touch = Touch::of(c);
      const LatticePlane plane{touch.at + touch.normal, lattice_across(c, touch.normal),
                               lattice_across(c, touch.normal)};
      const double far = power_of_two(c, 10, 13);
      return {in_some_order({plane.at(far, 0), plane.at(0, far), plane.at(-far, -far)}, c), touch.box};
    });
    add("edge_across_edge", [](DrawStream& c) -> Question {
      // Over an edge of the box that is parallel to an axis, past or across its line; and the triangle beyond it.
      const Aabb3d box = lattice_box(c, 12);
      const Vector3d displacement = lattice_normal(c, 4);
      const double out = one_to(c, 4), side = one_to(c, 4), up = small_integer(c), off = small_integer(c, 1),
                   near = small_integer(c, 3);
      const Point3d x{box.max.x + off, box.max.y, box.min.z + up};
      const Vector3d edge{side * displacement.x, -out * std::fabs(displacement.x), displacement.z};
      const Triangle3d t{along(x, near, edge), along(x, small_integer(c, 3), edge), x + Vector3d{out, side, up}};
      return {in_some_order(t, c), box};
    });
    add("on_small_grid", [](DrawStream& c) -> Question {
      return {triangle_of(c, small_lattice_point), {{1, 1, 1}, {one_to(c, 2), one_to(c, 2), 2}}};
    });
    add("parallel_to_axes", [](DrawStream& c) -> Question {
      const Aabb3d box = lattice_box(c, 12);
      const Point3d p = nearby(c, box), q = nearby(c, box), r = nearby(c, box);
      const Triangle3d t{p, {p.x, q.y, c.coin() ? p.z : q.z}, {c.coin() ? r.x : p.x, r.y, p.z}};
      return {in_some_order(t, c), box};
    });
    add("no_area", [](DrawStream& c) -> Question {
      const Aabb3d box = lattice_box(c, 12);
      const Vector3d displacement = lattice_normal(c, 3);
      const Point3d p = nearby(c, box);
      const double i = small_integer(c), j = small_integer(c), k = c.one_in(3) ? i : small_integer(c);
      return {{along(p, i, displacement), along(p, j, displacement), along(p, k, displacement)}, box};
    });
    add("triangle_is_point", [](DrawStream& c) -> Question {
      const Aabb3d box = lattice_box(c);
      const Point3d p = nearby(c, box);
      return {{p, p, p}, box};
    });
    add("flat", [](DrawStream& c) -> Question {
      const Aabb3d box = flat_box(c, 12);
      return {{nearby(c, box), nearby(c, box), nearby(c, box)}, box};
    });
    add("flat_without_area", [](DrawStream& c) -> Question {
      // A rectangle, a segment or a point, and a segment through it, along it or past it.
      const Aabb3d box = flat_box(c, 6);
      const Point3d p = within(box, c).max;
      const Vector3d displacement = lattice_normal(c, 3), off = lattice_normal(c, 2);
      const Point3d beside = along(p, small_integer(c, 1), off);
      const double i = small_integer(c, 3), j = small_integer(c, 3);
      return {{along(beside, i, displacement), along(beside, j, displacement),
               along(beside, small_integer(c, 3), displacement)},
              box};
    });
    add("flat_in_one_plane", [](DrawStream& c) -> Question {
      // A segment parallel to an axis, and a triangle in a plane with it, or near such a plane.
      Aabb3d box = lattice_box(c, 6);
      box.max.y = box.min.y, box.max.z = box.min.z;
      const LatticePlane plane{box.min, {1, 0, 0}, lattice_normal(c, 4)};
      const Triangle3d t = plane.triangle(c);
      const Vector3d off = c.one_in(3) ? lattice_normal(c, 2) : Vector3d{0, 0, 0};
      return {in_some_order({t.a + off, t.b + off, t.c + off}, c), box};
    });
    add("nearly_flat", [](DrawStream& c) -> Question {
      const Touch touch = Touch::of(c);
      const Vector3d u = lattice_across(c, touch.normal);
      Aabb3d box = touch.box;
      box.min.x = moved_by_ulps(box.max.x, -integer_in(c, 0, 2));
      const double back = small_integer(c, 1);
      const Point3d a = along(touch.at, back, touch.normal);
      return {{a + u, along(a, -1, u), touch.above(c)}, box};
    });
    add("needle", [](DrawStream& c) -> Question {
      const Aabb3d box = lattice_box(c, 4);
      const double length = power_of_two(c, 10, 41);
      const double y = small_integer(c), z = small_integer(c), dy = small_integer(c, 3), dz = small_integer(c, 3);
      const Triangle3d t{
          {-length, y, z}, {length, y + dy, z + dz}, {length, y + small_integer(c, 2), z + small_integer(c, 2)}};
      return {in_some_order(t, c), box};
    });
    add("sizes", [](DrawStream& c) -> Question {
      // One of the two is 2^16 to 2^24 times larger than the other.
      const Touch touch = Touch::of(c, 4);
      const double factor = power_of_two(c, 16, 24);
      const bool large = c.coin();
      const auto from = [&](const Point3d& p) { return along(touch.at, large ? factor : 1, p - touch.at); };
      const auto out = [&](const Point3d& p) { return large ? p : along(touch.at, factor, p - touch.at); };
      const Touch sized{{out(touch.box.min), out(touch.box.max)}, touch.normal, touch.at};
      return sized.question(
          c, {from(touch.at + lattice_across(c, touch.normal)), from(touch.above(c)), from(touch.above(c))});
    });
    add("rounded_onto_corner", [](DrawStream& c) -> Question {
      // The middle of an edge is rounded onto the corner max, or an ulp from it.
      const Point3d max = ordinary_point_in_space(c), p = ordinary_point_in_space(c);
      const Aabb3d box{{max.x - 0.25, max.y - 0.5, max.z - 1}, max};
      const Point3d q{2 * max.x - p.x, 2 * max.y - p.y, moved_by_ulps(2 * max.z - p.z, small(c))};
      const Vector3d away{std::fabs(ordinary(c)), std::fabs(ordinary(c)), std::fabs(ordinary(c))};
      return {{p, q, max + 4.0 * away}, box};
    });
    add("rounded_onto_plane", [](DrawStream& c) -> Question {
      // The corner max, as rounded, in the plane of the triangle; its normal has no sign but +.
      const Point3d a = ordinary_point_in_space(c);
      const auto positive = [&c] { return std::fabs(ordinary(c)); };
      const double u = 1 + positive(), v = 1 + positive(), s = positive() / 4, t = positive() / 4;
      const Point3d b{a.x + u, a.y, a.z - u * v}, d{a.x, a.y + v, a.z - v};
      const Point3d max{a.x + s * u, a.y + t * v, moved_by_ulps(a.z - s * u * v - t * v, small(c))};
      return {{a, b, d}, {{max.x - 1, max.y - 0.5, max.z - 0.25}, max}};
    });
    add("past_the_lattice", [](DrawStream& c) -> Question {
      // Points of one plane through the origin, of 53 digits at exponents far apart, and a corner on that plane.
      const LongPlane plane = LongPlane::of(c);
      const auto point = [&plane](DrawStream& d) {
        const int k = -16 * integer_in(d, 0, 3);
        return scaled(plane.point(d), k);
      };
      const Triangle3d t = triangle_of(c, point);
      const Point3d x = point(c);
      const double size = scaled_down(c, 4, 10);
      return {t, {x, x + Vector3d{size, size, size}}};
    });
    add("off_by_a_hair", [](DrawStream& c) -> Question {
      // A triangle on a face but for a hair, or rising from there.
      const double r = scaled_up(c, 4, 1000), most = scaled_up(c, 4, 1000), y = hair(c);
      const Aabb3d box = c.coin() ? Aabb3d{{-r, -r, -r}, {r, 0, r}} : Aabb3d{{-r, 0, -r}, {r, r, r}};
      return {{{-most, y, -most}, {most, c.coin() ? y : -y, 0}, {0, y, most}}, box};
    });
    add("stretched", [](DrawStream& c) -> Question {
      const Touch touch = Touch::of(c, 4);
      auto [t, box] = touch.question(c, {touch.above(c), touch.above(c), touch.at});
      Stretch{c}(t, box);
      return {t, box};
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      const Point3d a = typed_point(c), b = typed_point(c), p = typed_point(c), q = p + Vector3d{0.1, 0.2, 0.3};
      return {{a, b, q}, {p, q}};
    });
    add("subnormal", [](DrawStream& c) -> Question {
      const Point3d a = subnormal_point(c), b = subnormal_point(c);
      const Aabb3d box = box_of(c, [](DrawStream& d) { return subnormal(d); });
      return {{a, b, c.coin() ? lattice_point_in_space(c, 4) : subnormal_point(c)}, box};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      return {triangle_of(c, point_of_full_range), box_of(c, of_full_range)};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d a = zero_point(c), b = zero_point(c), d = zero_point(c), p = zero_point(c), q = zero_point(c);
      return {{a, c.coin() ? b : Point3d{1, 1, 1}, c.coin() ? d : Point3d{d.x, -1, d.z}},
              {p, c.coin() ? q : Point3d{1, 1, c.coin() ? q.z : 1}}};
    });
    add("edge_over_edge", [](DrawStream& c) -> Question { return edge_over_edge(c, integer_in(c, 0, 2)); });
    add("nearly_parallel_edges", [](DrawStream& c) -> Question { return edge_over_edge(c, integer_in(c, 4, 28)); });
  }

  static void repair(Question& q) { put_in_order(std::get<1>(q)); }

  /// An edge that meets the edge of the box over (24, 24); moves a corner.
  static Question map_centre() { return {{{36, 12, 6}, {12, 36, 6}, {60, 60, 20}}, {{0, 0, 0}, {24, 24, 12}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<triangle_aabb> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  static int small(DrawStream& c) { return integer_in(c, -1, 1); }

  /// A box and a point of it that lies farthest along a normal: a corner, or where coordinates of the normal are 0 a
  /// point of an edge or of a face.
  struct Touch {
    Aabb3d box;
    Vector3d normal;
    Point3d at;

    static Touch of(DrawStream& c, int bits = 16) {
      const Aabb3d box = lattice_box(c, bits);
      const auto slope = [&c] { return c.one_in(3) ? small_integer(c, 12) : small_integer(c, 1); };
      const double x = slope(), z = slope(), y = x == 0 && z == 0 ? 1 : slope();
      const Point3d beside = within(box, c).min;
      const auto end = [](double n, double min, double max, double other) { return n > 0 ? max : n < 0 ? min : other; };
      return {box,
              {x, y, z},
              {end(x, box.min.x, box.max.x, beside.x), end(y, box.min.y, box.max.y, beside.y),
               end(z, box.min.z, box.max.z, beside.z)}};
    }
    /// Not below the plane through the point, across the normal.
    Point3d above(DrawStream& c) const {
      const double up = up_to(c, 2);
      return along(at, up, normal) + lattice_across(c, normal);
    }
    /// Moved along the normal, sometimes.
    Question question(DrawStream& c, const Triangle3d& t) const {
      const double off = c.one_in(3) ? small_integer(c, 1) : 0.0;
      return {in_some_order({along(t.a, off, normal), along(t.b, off, normal), along(t.c, off, normal)}, c), box};
    }
  };

  /// In the box, of integers, or a few steps from there along some axes.
  static Point3d nearby(DrawStream& c, const Aabb3d& box) {
    const auto coordinate = [&c](double min, double max) {
      const double off = c.one_in(3) ? small_integer(c) : 0.0;
      return min + static_cast<double>(c.below(static_cast<std::uint64_t>(max - min) + 1)) + off;
    };
    return {coordinate(box.min.x, box.max.x), coordinate(box.min.y, box.max.y), coordinate(box.min.z, box.max.z)};
  }

  static Aabb3d flat_box(DrawStream& c, int bits) {
    Aabb3d box = lattice_box(c, bits);
    const auto axes = 1 + c.below(7);
    if ((axes & 1) != 0) box.max.x = box.min.x;
    if ((axes & 2) != 0) box.max.y = box.min.y;
    if ((axes & 4) != 0) box.max.z = box.min.z;
    return box;
  }
};

}  // namespace touchstone::catalogue::rows
