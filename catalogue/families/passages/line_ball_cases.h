// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "catalogue/families/passages/line_solid_cases.h"
#include "geometry/volumes.h"

/// Families of a line and a ball. Row::of(course, ball, in_plane): the question whose line has that course, in space or
/// in the plane.
namespace touchstone::catalogue {

/// A vector of whole length, and that length.
inline std::pair<Vector3d, double> integer_vector(DrawStream& c) {
  static constexpr std::array<std::array<double, 4>, 5> quadruples{
      {{3, 4, 0, 5}, {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {5, 12, 0, 13}}};
  const auto [x, y, z, r] = quadruples[c.below(5)];
  const double s = one_to(c, 8), sign = either_sign(c);
  return {{sign * x * s, y * s, z * s}, r * s};
}

/// A course that comes as near to the center as `foot` is, at a right angle to it; both in the plane z = 0.
inline Course course_beside(DrawStream& c, const Point3d& center, const Vector3d& foot) {
  const Vector3d across{-foot.y, foot.x, 0};
  return course_through(c, center + foot, across);
}

template <class Row>
void line_ball_cases(HardCases<typename Row::Question>& add) {
  using Question = typename Row::Question;
  add("tangent", [](DrawStream& c) -> Question {
    const double s = one_to(c, 64), off = small_integer(c, 1);
    const Point3d center = lattice_point_in_space(c, 12);
    return in_either<Row>(c, course_beside(c, center, {3 * s, 4 * s, 0}), Sphere3d{center, 5 * s + off});
  });
  add("whole_chord", [](DrawStream& c) -> Question {
    // At 15 s from the center, with radius 25 s: half the chord is 20 s.
    const double s = one_to(c, 64);
    const Point3d center = lattice_point_in_space(c, 12);
    return in_either<Row>(c, course_beside(c, center, {9 * s, 12 * s, 0}), Sphere3d{center, 25 * s});
  });
  add("starts_on_sphere", [](DrawStream& c) -> Question {
    const auto [p, r] = integer_vector(c);
    const Point3d center = lattice_point_in_space(c, 12);
    const bool in_plane = p.z == 0 && c.coin();
    const Vector3d v = c.coin() ? Vector3d{-p.y, p.x, 0} : lattice_normal(c, 4);
    return Row::of({center + p, v}, {center, r}, in_plane);
  });
  add("sphere_at_one", [](DrawStream& c) -> Question {
    const auto [p, r] = integer_vector(c);
    const Point3d center = lattice_point_in_space(c, 12);
    const Vector3d v = lattice_normal(c, 4);
    return Row::of({center + (p - v), v}, {center, r}, p.z == 0 && c.coin());
  });
  add("aimed", [](DrawStream& c) -> Question {
    const Point3d center = lattice_point_in_space(c, 6);
    const double x = small_integer(c, 2), y = small_integer(c, 2), z = small_integer(c, 2);
    const Vector3d v = lattice_normal(c, 6);
    const double radius = up_to(c, 11);
    return in_either<Row>(c, course_through(c, center + Vector3d{x, y, z}, v), Sphere3d{center, radius});
  });
  add("starts_inside", [](DrawStream& c) -> Question {
    const Vector3d p = lattice_normal(c, 4), v = lattice_normal(c, 6);
    const double less = c.coin() ? 0x1p-20 : 0, radius = 32 + up_to(c, 7) - less;
    return in_either<Row>(c, {{p.x, p.y, p.z}, v}, Sphere3d{{0, 0, 0}, radius});
  });
  add("point_ball", [](DrawStream& c) -> Question {
    const Point3d center = lattice_point_in_space(c, 12);
    const Vector3d v = lattice_normal(c, 6), aside{0, 0, small_integer(c, 1)};
    const Sphere3d point{center, zero(c)};
    return in_either<Row>(c, course_through(c, center + aside, v), point);
  });
  add("no_length", [](DrawStream& c) -> Question {
    const auto [p, r] = integer_vector(c);
    return in_either<Row>(c, {{p.x, p.y, p.z}, {0, -0.0, 0}}, Sphere3d{{0, 0, 0}, r + small_integer(c, 1)});
  });
  add("from_far_away", [](DrawStream& c) -> Question {
    // Tangent, or a chord of few digits, from where the squares cancel.
    const Sphere3d ball{{0, 0, 0}, 5 + std::ldexp(small_integer(c, 2), -10)};
    return in_either<Row>(c, course_from_afar(c, {3, 4, 0}, {-4, 3, 0}), ball);
  });
  add("direction_of_any_size", [](DrawStream& c) -> Question {
    const Point3d center = lattice_point_in_space(c, 6);
    const Vector3d v = lattice_normal(c, 4);
    const Sphere3d ball{center, up_to(c, 11)};
    const auto [from, displacement] = course_through(c, center, v);
    return in_either<Row>(c, {from, of_any_size(c, displacement)}, ball);
  });
  add("rounded_tangent", [](DrawStream& c) -> Question {
    // A touch at the start, at the nearest point, or at t = 1, as far as doubles can tell, or some ulps from there.
    const auto tenth = [&c] { return small_integer(c, 40) / 10; };
    const double x = tenth(), y = tenth(), z = tenth(), vx = tenth(), vy = tenth(), vz = 1 + std::fabs(tenth());
    const bool in_plane = vx != 0 && c.coin();
    const Vector3d p{x, y, in_plane ? 0 : z}, v{vx, vy, in_plane ? 0 : vz}, end = p + v, area = cross(p, v);
    const double reaches[]{std::sqrt(dot(area, area)) / std::sqrt(dot(v, v)), std::sqrt(dot(p, p)),
                           std::sqrt(dot(end, end))};
    const double reach = reaches[c.below(3)], r = within_ulps(c, reach, 2);
    return Row::of({{x, y, z}, {vx, vy, vz}}, {{0, 0, 0}, std::fabs(r)}, in_plane);
  });
  add("least_beside_greatest", [](DrawStream& c) -> Question {
    const double least = subnormal(c), greatest = huge(c);
    const Vector3d v = c.coin() ? Vector3d{-greatest, 0, 0} : Vector3d{-4, least, 0};
    const double x = c.coin() ? greatest : 3, r = c.coin() ? 1 : std::fabs(least);
    const Sphere3d ball{{0, 0, 0}, c.coin() ? greatest : r};
    return in_either<Row>(c, {{x, least, 0}, v}, ball);
  });
  add("either_zero", [](DrawStream& c) -> Question {
    const double x = zero(c), y = small_integer(c, 1), r = zero(c), v = small_integer(c, 1), more = zero(c);
    return in_either<Row>(c, {{x, y, more}, {more, v == 0 ? 1 : v, x}}, Sphere3d{{zero(c), 0, 0}, r});
  });
  add("typed_course", [](DrawStream& c) -> Question {
    const double x = typed(c), y = typed(c), vx = typed(c), vy = typed(c), r = std::fabs(typed(c));
    return in_either<Row>(c, {{x, y, 0.1}, {vx, vy, 0.3}}, Sphere3d{{0.1, 0.2, 0.3}, r});
  });
}

}  // namespace touchstone::catalogue
