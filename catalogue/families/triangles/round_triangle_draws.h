// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "catalogue/families/closest_draws.h"
#include "catalogue/families/round_draws.h"
#include "geometry/capsules.h"

/// Hard cases of triangles that balls and capsules meet.
namespace touchstone::catalogue {

using BallAndTriangle = std::tuple<Sphere3d, Triangle3d>;
using CapsuleAndTriangle = std::tuple<Capsule3d, Triangle3d>;

/// Calls add(name, draw) for each.
template <class Add>
void add_balls_and_triangles(const Add& add) {
  add("tangent_to_face", [](DrawStream& c) -> BallAndTriangle {
    const IntegerAcross across = IntegerAcross::of(c);
    const LatticePlane plane{lattice_point_in_space(c, 16), across.u, across.v};
    const Triangle3d t = plane.triangle(c);
    return {{plane.point(c) + across.displacement, reaching(c, across.length)}, t};
  });
  add("tangent_to_edge", [](DrawStream& c) -> BallAndTriangle {
    const IntegerAcross across = IntegerAcross::of(c);
    const LatticePlane edge{lattice_point_in_space(c, 16), across.u, across.displacement};
    const double i = small_integer(c, 3), j = small_integer(c, 3), back = -up_to(c, 3);
    const Triangle3d t{edge.at(i, 0), edge.at(j, 0), edge.at(small_integer(c, 3), back) + across.v};
    return {{edge.at(small_integer(c, 3), 1), reaching(c, across.length)}, t};
  });
  add("tangent_to_corner", [](DrawStream& c) -> BallAndTriangle {
    const Step step = integer_step(c);
    const Point3d corner = lattice_point_in_space(c, 16);
    const auto back = [&] {
      const double i = -up_to(c, 2);
      return along(corner, i, step.displacement) + lattice_across(c, step.displacement);
    };
    const Point3d a = back(), b = back();
    return {{corner + step.displacement, reaching(c, step.length)}, {a, b, corner}};
  });
  add("center_in_plane_or_triangle", [](DrawStream& c) -> BallAndTriangle {
    const LatticePlane plane = LatticePlane::of(c, 6);
    const Triangle3d t = plane.triangle(c);
    const double r = up_to(c, 2);
    return {{plane.point(c), r}, t};
  });
  add("point_ball", [](DrawStream& c) -> BallAndTriangle {
    const LatticePlane plane = LatticePlane::of(c, 6);
    const Triangle3d t = plane.triangle(c);
    return {{plane.point(c), zero(c)}, t};
  });
  add("no_area", [](DrawStream& c) -> BallAndTriangle {
    const IntegerAcross across = IntegerAcross::of(c);
    const LatticePlane line{lattice_point_in_space(c, 16), across.u, across.displacement};
    const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
    return {{line.at(small_integer(c, 3), 1), reaching(c, across.length)},
            {line.at(i, 0), line.at(j, 0), line.at(k, 0)}};
  });
  add("triangle_is_point", [](DrawStream& c) -> BallAndTriangle {
    const Step step = integer_step(c);
    const Point3d p = lattice_point_in_space(c, 16);
    return {{p + step.displacement, reaching(c, step.length)}, {p, p, p}};
  });
  add("near_root", [](DrawStream& c) -> BallAndTriangle {
    const auto [x, r] = near_root(c);
    const double far = one_to(c, 8);
    return {{{r, r, integer(c, 10)}, x}, {{0, 0, -4096}, {0, 0, 4096}, {-far, 0, 0}}};
  });
  add("rounded_tangent", [](DrawStream& c) -> BallAndTriangle {
    const Point3d p = ordinary_point_in_space(c), a = ordinary_point_in_space(c);
    const Vector3d displacement = p - a;
    return {{p, near_length(c, displacement)}, {a, along(a, -1, displacement), a + lattice_across(c, {1, 0, 0})}};
  });
  add("needle", [](DrawStream& c) -> BallAndTriangle {
    const double length = power_of_two(c, 20, 41), y = small_integer(c, 3), z = small_integer(c, 3);
    const Triangle3d t{{-length, y, z}, {length, small_integer(c, 3), 0}, {length, 0, small_integer(c, 3)}};
    const Point3d p = lattice_point_in_space(c, 4);
    return {{p, reaching(c, std::fabs(p.y))}, t};
  });
  add("off_by_a_hair", [](DrawStream& c) -> BallAndTriangle {
    const double r = scaled_up(c, 4, 1000), most = scaled_up(c, 4, 1000);
    return {{{0, either_sign(c) * r, 0}, r}, {{-most, hair(c), -most}, {most, 0, -most}, {0, 0, most}}};
  });
  add("stretched", [](DrawStream& c) -> BallAndTriangle {
    const LatticePlane plane = LatticePlane::of(c);
    Triangle3d t = plane.triangle(c);
    Point3d p = plane.point(c);
    Stretch{c}(p, t);
    return {{p, scaled_down(c, 4, 300)}, t};
  });
  add("typed_shapes", [](DrawStream& c) -> BallAndTriangle {
    const Point3d p = typed_point(c), a = typed_point(c), b = typed_point(c);
    return {{p, std::fabs(typed(c))}, {a, b, {p.x, p.y + 0.5, p.z}}};
  });
  add("subnormal", [](DrawStream& c) -> BallAndTriangle {
    const Point3d p = subnormal_point(c), a = subnormal_point(c), b = subnormal_point(c);
    const double r = std::ldexp(up_to(c, 5), -1074);
    return {{p, r}, {a, b, c.coin() ? lattice_point_in_space(c, 4) : subnormal_point(c)}};
  });
  add("whole_range", [](DrawStream& c) -> BallAndTriangle {
    const Point3d p = point_of_full_range(c), a = point_of_full_range(c), b = point_of_full_range(c);
    return {{p, std::fabs(of_full_range(c))}, {a, b, point_of_full_range(c)}};
  });
  add("either_zero", [](DrawStream& c) -> BallAndTriangle {
    const Point3d p = zero_point(c), a = zero_point(c), b = zero_point(c), d = zero_point(c);
    const double r = c.coin() ? -0.0 : up_to(c, 1);
    return {{p, r}, {a, c.coin() ? b : Point3d{1, b.y, b.z}, d}};
  });
}

/// Calls add(name, draw) for each.
template <class Add>
void add_capsules_and_triangles(const Add& add) {
  add("tangent_along", [](DrawStream& c) -> CapsuleAndTriangle {
    // Along the face, or an end over it.
    const IntegerAcross across = IntegerAcross::of(c);
    const LatticePlane plane{lattice_point_in_space(c, 16), across.u, across.v};
    const Triangle3d t = plane.triangle(c);
    const Point3d p = plane.point(c) + across.displacement, q = plane.point(c) + across.displacement;
    const double away = up_to(c, 1);
    return {{{p, along(q, away, across.displacement)}, reaching(c, across.length)}, t};
  });
  add("across_edge", [](DrawStream& c) -> CapsuleAndTriangle {
    // Over an edge, at any angle; the triangle is behind it.
    const IntegerAcross across = IntegerAcross::of(c);
    const Point3d p = lattice_point_in_space(c, 16), over = p + across.displacement;
    const double i = small_integer(c, 2), j = small_integer(c, 2), back = -up_to(c, 2);
    const Triangle3d t{along(p, i, across.u), along(p, j, across.u), along(p, back, across.displacement) + across.v};
    const Segment3d segment = segment_through(c, over, across.v);
    return {{segment, reaching(c, across.length)}, in_some_order(t, c)};
  });
  add("through_plane", [](DrawStream& c) -> CapsuleAndTriangle {
    // Through the triangle, or past it.
    const LatticePlane plane = LatticePlane::of(c, 6);
    const Triangle3d t = plane.triangle(c);
    const Point3d p = plane.point(c);
    const Segment3d segment = segment_through(c, p, lattice_normal(c, 6));
    return {{segment, c.coin() ? zero(c) : up_to(c, 2)}, t};
  });
  add("through_the_middle", [](DrawStream& c) -> CapsuleAndTriangle {
    // All edges and both ends are farther away than the radius.
    const LatticePlane plane = LatticePlane::of(c, 4);
    const Point3d p = plane.origin;
    const double far = one_to(c, 9), back = one_to(c, 9);
    const Triangle3d t{plane.at(16, 0), plane.at(0, 16), plane.at(-16, -16)};
    const Vector3d n = cross(plane.u, plane.v);
    return {{{along(p, -back, n), along(p, far, n)}, up_to(c, 1)}, in_some_order(t, c)};
  });
  add("in_plane", [](DrawStream& c) -> CapsuleAndTriangle {
    const LatticePlane plane = LatticePlane::of(c, 6);
    const Triangle3d t = plane.triangle(c);
    const Segment3d segment{plane.point(c), plane.point(c)};
    return {{segment, c.coin() ? zero(c) : up_to(c, 9)}, t};
  });
  add("parallel_lines", [](DrawStream& c) -> CapsuleAndTriangle {
    // A triangle without area near a segment of its direction.
    const IntegerAcross across = IntegerAcross::of(c);
    const LatticePlane line{lattice_point_in_space(c, 16), across.u, across.displacement};
    const Triangle3d t = line.triangle_without_area(c);
    const double i = small_integer(c, 4), j = small_integer(c, 4);
    return {{{line.at(i, 1), line.at(j, 1)}, reaching(c, across.length)}, t};
  });
  add("moderate_ends", [](DrawStream& c) -> CapsuleAndTriangle {
    // The greatest and the least numbers that the filter takes, and the next beyond them; tangent, or far from that.
    const double large = power_of_two(c, 29, 31), least = power_of_two(c, -32, -29), side = small_integer(c, 1);
    const double far = c.coin() ? 0 : large / 2, r = c.coin() ? least : large;
    return {{{{far + r, side * least, 0}, {2 * large, far, least}}, r},
            {{0, large, 0}, {0, -large, least}, {-1, 0, 0}}};
  });
  add_balls_and_triangles([&add]<class Draw>(const char* family, const Draw&) {
    add(family, [](DrawStream& c) -> CapsuleAndTriangle { return ending_in(Draw()(c), c); });
  });
}

}  // namespace touchstone::catalogue
