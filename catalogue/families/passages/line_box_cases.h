// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/box_draws.h"
#include "catalogue/families/passages/line_solid_cases.h"
#include "catalogue/families/ties.h"

/// Families of a line and a box. Row::of(course, box, in_plane): the question whose line has that course, in space, or
/// the same without z.
namespace touchstone::catalogue {

/// A corner of the box, or a point on an edge or a face: as many coordinates as said are at one end.
inline Point3d on_boundary(DrawStream& c, const Aabb3d& box, int at_ends) {
  Point3d p = within(box, c).min;
  const auto end = [&c](double min, double max) { return c.coin() ? max : min; };
  p.x = end(box.min.x, box.max.x);
  if (at_ends > 1) p.y = end(box.min.y, box.max.y);
  if (at_ends > 2) p.z = end(box.min.z, box.max.z);
  return p;
}

template <class Row>
void line_box_cases(HardCases<typename Row::Question>& add) {
  using Question = typename Row::Question;
  add("through_inside", [](DrawStream& c) -> Question {
    const Aabb3d box = lattice_box(c, 12);
    const Point3d x = within(box, c).min;
    return in_either<Row>(c, course_through(c, x, lattice_normal(c, 6)), box);
  });
  add("through_corner", [](DrawStream& c) -> Question {
    const Aabb3d box = lattice_box(c, 12);
    const bool in_plane = c.coin();
    const Point3d x = on_boundary(c, box, in_plane ? 2 : 3);
    return Row::of(course_through(c, x, lattice_normal(c, 3)), box, in_plane);
  });
  add("through_edge", [](DrawStream& c) -> Question {
    const Aabb3d box = lattice_box(c, 12);
    const Point3d x = on_boundary(c, box, 2);
    return Row::of(course_through(c, x, lattice_normal(c, 3)), box, false);
  });
  add("along_face", [](DrawStream& c) -> Question {
    // In its plane, or just outside of it.
    const Aabb3d box = lattice_box(c, 12);
    Point3d x = on_boundary(c, box, 1);
    x.x += small_integer(c, 1);
    return in_either<Row>(c, course_through(c, x, {0, one_to(c, 3), small_integer(c, 3)}), box);
  });
  add("along_edge", [](DrawStream& c) -> Question {
    const Aabb3d box = lattice_box(c, 12);
    const Point3d x = on_boundary(c, box, 2);
    const double none = zero(c), v = one_to(c, 3);
    return Row::of(course_through(c, x, {none, 0, either_sign(c) * v}), box, false);
  });
  add("along_axis", [](DrawStream& c) -> Question {
    const Aabb3d box = lattice_box(c, 12);
    Point3d x = within(box, c).min;
    x.y += small_integer(c, 2);
    const double v = one_to(c, 8);
    return in_either<Row>(c, course_through(c, x, {either_sign(c) * v, 0, -0.0}), box);
  });
  add("starts_on_boundary", [](DrawStream& c) -> Question {
    const Aabb3d box = lattice_box(c, 12);
    return in_either<Row>(c, {on_boundary(c, box, integer_in(c, 1, 3)), lattice_normal(c, 6)}, box);
  });
  add("starts_inside", [](DrawStream& c) -> Question {
    const Aabb3d box = lattice_box(c, 12);
    return in_either<Row>(c, {within(box, c).min, lattice_normal(c, 6)}, box);
  });
  add("flat_and_points", [](DrawStream& c) -> Question {
    Aabb3d box = lattice_box(c, 12);
    const Point3d x = within(box, c).min;
    box.max.x = box.min.x = x.x;
    if (c.coin()) box.max.y = box.min.y = x.y;
    if (c.coin()) box.max.z = box.min.z = x.z;
    const Vector3d aside{0, small_integer(c, 1), 0}, v = lattice_normal(c, 3);
    return in_either<Row>(c, course_through(c, x + aside, v), box);
  });
  add("no_length", [](DrawStream& c) -> Question {
    const Aabb3d box = lattice_box(c, 12);
    Point3d x = on_boundary(c, box, 1);
    x.x += small_integer(c, 1);
    return in_either<Row>(c, {x, {0, -0.0, 0}}, box);
  });
  add("small_lattice", [](DrawStream& c) -> Question {
    const auto digit = [&c] { return up_to(c, 3); };
    const double x = digit(), y = digit(), z = digit(), vx = digit() - 1, vy = digit() - 1, vz = digit() - 1;
    const double dx = digit(), dy = digit(), dz = digit();
    const Vector3d v{vx, vy, vx == 0 && vy == 0 && vz == 0 ? 1 : vz};
    return in_either<Row>(c, {{x, y, z}, v}, Aabb3d{{1, 1, 1}, {1 + dx, 1 + dy, 1 + dz}});
  });
  add("from_far_away", [](DrawStream& c) -> Question {
    const Point3d x{small_integer(c, 1), small_integer(c, 1), 0};
    return in_either<Row>(c, course_from_afar(c, x, lattice_normal(c, 3)), Aabb3d{{0, 0, 0}, {1, 1, 1}});
  });
  add("direction_of_any_size", [](DrawStream& c) -> Question {
    const Aabb3d box = lattice_box(c, 12);
    const Point3d x = within(box, c).min;
    const Vector3d v = lattice_normal(c, 6);
    const auto [from, displacement] = course_through(c, x, v);
    return in_either<Row>(c, {from, of_any_size(c, displacement)}, box);
  });
  add("rounded_corner_pass", [](DrawStream& c) -> Question {
    // Out of x's slab when into y's, as far as doubles can tell, or an ulp from that.
    const double t = (1 + std::fabs(ordinary(c))) / 4, x = 1 + std::fabs(ordinary(c)), y = 1 + std::fabs(ordinary(c));
    const double u = std::ldexp(ordinary(c), -54), v = std::ldexp(ordinary(c), -54);
    const int ulps = integer_in(c, -1, 1);
    return in_either<Row>(c, {{u, v, 0}, {x, y, 0}}, Aabb3d{{-1, moved_by_ulps(t * y, ulps), -1}, {t * x, 4, 1}});
  });
  add("beside_a_tie", [](DrawStream& c) -> Question {
    // The entry, in units of 2^-54.
    const auto [low, high, speed] = way_beside_tie(c);
    return in_either<Row>(c, {{-low, 0, 0}, {speed * 0x1p54, 0, 0}}, Aabb3d{{high, -1, -1}, {0x1p90, 1, 1}});
  });
  add("least_beside_greatest", [](DrawStream& c) -> Question {
    const double least = subnormal(c), greatest = huge(c), v = c.coin() ? greatest : 4, y = c.coin() ? least : 1;
    const double from = c.coin() ? -greatest : -4, end = c.coin() ? greatest : 1;
    return in_either<Row>(c, {{from, least, 0}, {v, y, 0}}, Aabb3d{{0, 0, 0}, {end, 1, 1}});
  });
  add("either_zero", [](DrawStream& c) -> Question {
    const double x = zero(c), y = zero(c), vx = zero(c), vy = small_integer(c, 1), low = zero(c), high = zero(c);
    return in_either<Row>(c, {{x, y, -1}, {vx, vy, 1}}, Aabb3d{{low, low, zero(c)}, {high, 1, 1}});
  });
  add("typed_course", [](DrawStream& c) -> Question {
    const double x = typed(c), y = typed(c), vx = typed(c), vy = typed(c), size = std::fabs(typed(c));
    return in_either<Row>(c, {{x, y, 0.1}, {vx, vy, 0.3}}, Aabb3d{{0, -0.3, 0}, {size, 0.1, size}});
  });
  add("wide", [](DrawStream& c) -> Question {
    const Vector3d by = fractions(c);
    const Aabb3d box = lattice_box(c, 12);
    const Point3d x = within(box, c).min;
    const Vector3d v = lattice_normal(c, 4);
    const auto [from, displacement] = course_through(c, x, v);
    return in_either<Row>(c, {from + by, displacement}, widened(box, from, c));
  });
}

}  // namespace touchstone::catalogue
