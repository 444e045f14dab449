// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/box_draws.h"
#include "catalogue/families/closest_draws.h"
#include "catalogue/families/edge_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "oracle/mixed/triangle_aabb.h"
#include "reference/mixed/triangle_aabb.h"
#include "reference/standard/triangle_in_box.h"
#include "robust/mixed/triangle_aabb.h"

namespace touchstone::catalogue::rows {

struct triangle_aabb {
  TOUCHSTONE_MODULES(triangle_aabb)
  using stages = ::touchstone::robust::stages::triangle_aabb;
  using Question = std::tuple<Triangle3d, Aabb3d>;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{.name = "triangle_aabb",
                                   .chapter = "mixed",
                                   .pages = "21, 27, 45-47, 54",
                                   .question = "Do a triangle and an axis-aligned box overlap, only touch, or neither?",
                                   .kind = Kind::decision,
                                   .fields = {"triangle", "aabb"},
                                   .answer = "contact",
                                   .margin_degree = 1};
    return metadata;
  }

  static void standard(const auto& add) {
    add("Akenine-Moeller, seen from the box's center",
        [](const auto&... q) { return ::touchstone::reference::standard::triangle_aabb(q...); });
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"corner_on_boundary",
         [](DrawStream& c) -> Question {
           const Touch touch = Touch::of(c);
           const Point3d b = touch.above(c);
           return touch.question(c, touch.at, b, touch.above(c));
         }},
        {"edge_on_boundary",
         [](DrawStream& c) -> Question {
           const Touch touch = Touch::of(c);
           const Vector3d way = lattice_across(c, touch.normal);
           const double before = -static_cast<double>(c.below(3)), after = 1 + static_cast<double>(c.below(3));
           return touch.question(c, along(touch.at, before, way), along(touch.at, after, way), touch.above(c));
         }},
        {"triangle_on_boundary",
         [](DrawStream& c) -> Question {
           const Touch touch = Touch::of(c);
           const Vector3d u = lattice_across(c, touch.normal), v = lattice_across(c, touch.normal);
           return touch.question(c, touch.at + u, touch.at + v, along(along(touch.at, -1, u), -1, v));
         }},
        {"in_plane_through_corner",
         [](DrawStream& c) -> Question {
           const Touch touch = Touch::of(c);
           const Vector3d u = lattice_across(c, touch.normal);
           const Triangle3d t = LatticePlane{touch.at, u, lattice_across(c, touch.normal)}.triangle(c);
           return touch.question(c, t.a, t.b, t.c);
         }},
        {"past_corner",
         [](DrawStream& c) -> Question {
           // So large that nothing but its plane keeps them apart.
           const Touch touch = Touch::of(c);
           const Point3d over = touch.at + touch.normal;
           const Vector3d u = lattice_across(c, touch.normal), v = lattice_across(c, touch.normal);
           const double far = std::ldexp(1, 10 + static_cast<int>(c.below(4)));
           return in_some_order(
               c, {{along(over, far, u), along(over, far, v), along(along(over, -far, u), -far, v)}, touch.box});
         }},
        {"edge_across_edge",
         [](DrawStream& c) -> Question {
           // Over an edge of the box that is parallel to an axis, past or across its line; and the triangle beyond it.
           const Aabb3d box = lattice_box(c, 12);
           const Vector3d way = lattice_normal(c, 4);
           const double out = 1 + static_cast<double>(c.below(4)), side = 1 + static_cast<double>(c.below(4)),
                        up = small_integer(c), off = small_integer(c, 1), near = small_integer(c, 3);
           const Point3d x{box.max.x + off, box.max.y, box.min.z + up};
           const Vector3d edge{side * way.x, -out * std::fabs(way.x), way.z};
           const Triangle3d t{along(x, near, edge), along(x, small_integer(c, 3), edge), x + Vector3d{out, side, up}};
           return in_some_order(c, {t, box});
         }},
        {"on_small_grid",
         [](DrawStream& c) -> Question {
           const Point3d a = small_lattice_point(c), b = small_lattice_point(c), d = small_lattice_point(c);
           const double x = 1 + static_cast<double>(c.below(2)), y = 1 + static_cast<double>(c.below(2));
           return {{a, b, d}, {{1, 1, 1}, {x, y, 2}}};
         }},
        {"parallel_to_axes",
         [](DrawStream& c) -> Question {
           const Aabb3d box = lattice_box(c, 12);
           const Point3d p = nearby(c, box), q = nearby(c, box), r = nearby(c, box);
           const Triangle3d t{p, {p.x, q.y, c.below(2) == 1 ? p.z : q.z}, {c.below(2) == 1 ? r.x : p.x, r.y, p.z}};
           return in_some_order(c, {t, box});
         }},
        {"no_area",
         [](DrawStream& c) -> Question {
           const Aabb3d box = lattice_box(c, 12);
           const Vector3d way = lattice_normal(c, 3);
           const Point3d p = nearby(c, box);
           const double i = small_integer(c), j = small_integer(c), k = c.below(3) == 2 ? i : small_integer(c);
           return {{along(p, i, way), along(p, j, way), along(p, k, way)}, box};
         }},
        {"triangle_is_point",
         [](DrawStream& c) -> Question {
           const Aabb3d box = lattice_box(c);
           const Point3d p = nearby(c, box);
           return {{p, p, p}, box};
         }},
        {"flat",
         [](DrawStream& c) -> Question {
           const Aabb3d box = flat_box(c, 12);
           const Point3d a = nearby(c, box), b = nearby(c, box);
           return {{a, b, nearby(c, box)}, box};
         }},
        {"flat_without_area",
         [](DrawStream& c) -> Question {
           // A rectangle, a segment or a point, and a segment through, along or beside it.
           const Aabb3d box = flat_box(c, 6);
           const Point3d p = within(box, c).max;
           const Vector3d way = lattice_normal(c, 3), off = lattice_normal(c, 2);
           const Point3d beside = along(p, small_integer(c, 1), off);
           const double i = small_integer(c, 3), j = small_integer(c, 3);
           return {{along(beside, i, way), along(beside, j, way), along(beside, small_integer(c, 3), way)}, box};
         }},
        {"flat_in_one_plane",
         [](DrawStream& c) -> Question {
           // A segment parallel to an axis, and a triangle in a plane with it, or beside such a plane.
           Aabb3d box = lattice_box(c, 6);
           box.max.y = box.min.y, box.max.z = box.min.z;
           const LatticePlane plane{box.min, {1, 0, 0}, lattice_normal(c, 4)};
           const Triangle3d t = plane.triangle(c);
           const Vector3d off = c.below(3) == 2 ? lattice_normal(c, 2) : Vector3d{0, 0, 0};
           return in_some_order(c, {{t.a + off, t.b + off, t.c + off}, box});
         }},
        {"nearly_flat",
         [](DrawStream& c) -> Question {
           const Touch touch = Touch::of(c);
           const Vector3d u = lattice_across(c, touch.normal);
           Aabb3d box = touch.box;
           box.min.x = moved_by_ulps(box.max.x, -static_cast<int>(c.below(3)));
           const double back = small_integer(c, 1);
           const Point3d a = along(touch.at, back, touch.normal);
           return {{a + u, along(a, -1, u), touch.above(c)}, box};
         }},
        {"needle",
         [](DrawStream& c) -> Question {
           const Aabb3d box = lattice_box(c, 4);
           const double length = std::ldexp(1, 10 + static_cast<int>(c.below(32)));
           const double y = small_integer(c), z = small_integer(c), dy = small_integer(c, 3), dz = small_integer(c, 3);
           const Triangle3d t{
               {-length, y, z}, {length, y + dy, z + dz}, {length, y + small_integer(c, 2), z + small_integer(c, 2)}};
           return in_some_order(c, {t, box});
         }},
        {"sizes",
         [](DrawStream& c) -> Question {
           // One of the two is 2^16 to 2^24 times larger than the other.
           const Touch touch = Touch::of(c, 4);
           const double factor = std::ldexp(1, 16 + static_cast<int>(c.below(9)));
           const bool large = c.below(2) == 1;
           const auto from = [&](const Point3d& p) { return along(touch.at, large ? factor : 1, p - touch.at); };
           const auto out = [&](double x, double at) { return large ? x : at + factor * (x - at); };
           const auto& [min, max] = touch.box;
           const auto& [x, y, z] = touch.at;
           const Aabb3d box{{out(min.x, x), out(min.y, y), out(min.z, z)},
                            {out(max.x, x), out(max.y, y), out(max.z, z)}};
           const Vector3d u = lattice_across(c, touch.normal);
           const Point3d b = touch.above(c);
           return Touch{box, touch.normal, touch.at}.question(c, from(touch.at + u), from(b), from(touch.above(c)));
         }},
        {"rounded_onto_corner",
         [](DrawStream& c) -> Question {
           // The middle of an edge is rounded onto the corner max, or an ulp beside it.
           const Point3d max = ordinary_point_in_space(c), p = ordinary_point_in_space(c);
           const Aabb3d box{{max.x - 0.25, max.y - 0.5, max.z - 1}, max};
           const Point3d q{2 * max.x - p.x, 2 * max.y - p.y, moved_by_ulps(2 * max.z - p.z, small(c))};
           const Vector3d away{std::fabs(ordinary(c)), std::fabs(ordinary(c)), std::fabs(ordinary(c))};
           return {{p, q, max + 4.0 * away}, box};
         }},
        {"rounded_onto_plane",
         [](DrawStream& c) -> Question {
           // The corner max, as rounded, in the plane of the triangle; its normal has no sign but +.
           const Point3d a = ordinary_point_in_space(c);
           const double u = 1 + std::fabs(ordinary(c)), v = 1 + std::fabs(ordinary(c)), s = std::fabs(ordinary(c)) / 4,
                        t = std::fabs(ordinary(c)) / 4;
           const Point3d b{a.x + u, a.y, a.z - u * v}, d{a.x, a.y + v, a.z - v};
           const Point3d max{a.x + s * u, a.y + t * v, moved_by_ulps(a.z - s * u * v - t * v, small(c))};
           return {{a, b, d}, {{max.x - 1, max.y - 0.5, max.z - 0.25}, max}};
         }},
        {"past_the_lattice",
         [](DrawStream& c) -> Question {
           // Points of one plane through the origin, of 53 digits at exponents far apart, and a corner on that plane.
           const LongPlane plane = LongPlane::of(c);
           const auto point = [&] {
             const double size = std::ldexp(1, -16 * static_cast<int>(c.below(4)));
             const Point3d p = plane.point(c);
             return Point3d{size * p.x, size * p.y, size * p.z};
           };
           const Point3d a = point(), b = point(), d = point(), x = point();
           const double size = scaled_down(c, 4, 10);
           return {{a, b, d}, {x, {x.x + size, x.y + size, x.z + size}}};
         }},
        {"off_by_a_hair",
         [](DrawStream& c) -> Question {
           // A triangle on a face but for a hair, or rising from there.
           const double r = scaled_up(c, 4, 1000), most = scaled_up(c, 4, 1000), y = hair(c);
           const Aabb3d box = c.below(2) == 1 ? Aabb3d{{-r, -r, -r}, {r, 0, r}} : Aabb3d{{-r, 0, -r}, {r, r, r}};
           return {{{-most, y, -most}, {most, c.below(2) == 1 ? y : -y, 0}, {0, y, most}}, box};
         }},
        {"stretched",
         [](DrawStream& c) -> Question {
           auto [t, box] = Touch::of(c, 4).beside(c);
           stretch(c, t.a, t.b, t.c, box.min, box.max);
           return {t, box};
         }},
        {"typed",
         [](DrawStream& c) -> Question {
           const Point3d a = typed_point(c), b = typed_point(c), p = typed_point(c);
           return {{a, b, {p.x + 0.1, p.y + 0.2, p.z + 0.3}}, {p, {p.x + 0.1, p.y + 0.2, p.z + 0.3}}};
         }},
        {"subnormal",
         [](DrawStream& c) -> Question {
           const Point3d a = subnormal_point(c), b = subnormal_point(c), p = subnormal_point(c), q = subnormal_point(c);
           return ordered({{a, b, c.below(2) == 1 ? lattice_point_in_space(c, 4) : subnormal_point(c)}, {p, q}});
         }},
        {"whole_range",
         [](DrawStream& c) -> Question {
           const Point3d a = point_of_whole_range(c), b = point_of_whole_range(c), d = point_of_whole_range(c),
                         p = point_of_whole_range(c);
           return ordered({{a, b, d}, {p, point_of_whole_range(c)}});
         }},
        {"either_zero",
         [](DrawStream& c) -> Question {
           const Point3d a = zero_point(c), b = zero_point(c), d = zero_point(c), p = zero_point(c), q = zero_point(c);
           return {{a, c.below(2) == 1 ? b : Point3d{1, 1, 1}, c.below(2) == 1 ? d : Point3d{d.x, -1, d.z}},
                   {p, c.below(2) == 1 ? q : Point3d{1, 1, c.below(2) == 1 ? q.z : 1}}};
         }},
        {"edge_over_edge",
         [](DrawStream& c) -> Question {
           const auto steep = static_cast<int>(c.below(3));
           return edge_over_edge(c, steep);
         }},
        {"nearly_parallel_edges",
         [](DrawStream& c) -> Question {
           const auto steep = 4 + static_cast<int>(c.below(25));
           return edge_over_edge(c, steep);
         }},
    };
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
  static int small(DrawStream& c) { return static_cast<int>(c.below(3)) - 1; }

  /// A box and a point of it that lies farthest along a normal: a corner, or where coordinates of the normal are 0 a
  /// point of an edge or of a face.
  struct Touch {
    Aabb3d box;
    Vector3d normal;
    Point3d at;

    static Touch of(DrawStream& c, int bits = 16) {
      const Aabb3d box = lattice_box(c, bits);
      const auto slope = [&c] { return c.below(3) == 2 ? small_integer(c, 12) : small_integer(c, 1); };
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
      const double up = static_cast<double>(c.below(3));
      return along(at, up, normal) + lattice_across(c, normal);
    }
    /// Moved along the normal, sometimes.
    Question question(DrawStream& c, const Point3d& p, const Point3d& q, const Point3d& r) const {
      const double off = c.below(3) == 2 ? small_integer(c, 1) : 0.0;
      return in_some_order(c, {{along(p, off, normal), along(q, off, normal), along(r, off, normal)}, box});
    }
    Question beside(DrawStream& c) const {
      const Point3d p = above(c), q = above(c);
      return question(c, p, q, at);
    }
  };

  static Question in_some_order(DrawStream& c, const Question& q) {
    return {catalogue::in_some_order(std::get<0>(q), c), std::get<1>(q)};
  }

  /// In the box, of integers, or a few steps from there along some axes.
  static Point3d nearby(DrawStream& c, const Aabb3d& box) {
    const auto coordinate = [&c](double min, double max) {
      const double off = c.below(3) == 2 ? small_integer(c) : 0.0;
      return min + static_cast<double>(c.below(static_cast<std::uint64_t>(max - min) + 1)) + off;
    };
    const double x = coordinate(box.min.x, box.max.x), y = coordinate(box.min.y, box.max.y);
    return {x, y, coordinate(box.min.z, box.max.z)};
  }

  static Aabb3d flat_box(DrawStream& c, int bits) {
    Aabb3d box = lattice_box(c, bits);
    const auto axes = 1 + c.below(7);
    if ((axes & 1) != 0) box.max.x = box.min.x;
    if ((axes & 2) != 0) box.max.y = box.min.y;
    if ((axes & 4) != 0) box.max.z = box.min.z;
    return box;
  }

  static Question ordered(Question q) {
    repair(q);
    return q;
  }
};

}  // namespace touchstone::catalogue::rows
