// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "catalogue/families/closest_draws.h"
#include "geometry/capsules.h"

/// Hard cases of two capsules.
namespace touchstone::catalogue {

using CapsulePair = std::tuple<Capsule3d, Capsule3d>;

/// Calls add(name, draw) for each.
template <class Add>
void add_pairs_of_capsules(const Add& add) {
  add("tangent_beside", [](DrawStream& c) -> CapsulePair {
    // On parallel planes, crossing as seen from above or not; parallel, too.
    const IntegerAcross across = IntegerAcross::of(c);
    const Point3d p = lattice_point_in_space(c, 16);
    const auto [r, s] = reaching_radii(c, across.length);
    const Vector3d other = c.one_in(3) ? across.u : across.v;
    return {{segment_through(c, p, across.u), r}, {segment_through(c, p + across.displacement, other), s}};
  });
  add("tangent_at_ends", [](DrawStream& c) -> CapsulePair {
    const Step step = integer_step(c);
    const Point3d p = lattice_point_in_space(c, 16), q = p + step.displacement;
    const auto [r, s] = reaching_radii(c, step.length);
    const double back = -up_to(c, 2), on = up_to(c, 2);
    const Point3d behind = along(p, back, step.displacement) + lattice_across(c, step.displacement);
    return {{{behind, p}, r}, {{q, along(q, on, step.displacement) + lattice_across(c, step.displacement)}, s}};
  });
  add("collinear", [](DrawStream& c) -> CapsulePair {
    const Step step = integer_step(c);
    const Point3d p = lattice_point_in_space(c, 16);
    const double i = small_integer(c, 2), j = small_integer(c, 2), k = small_integer(c, 2);
    const auto [r, s] = reaching_radii(c, step.length);
    return {{{along(p, i, step.displacement), along(p, j, step.displacement)}, r},
            {{along(p, k, step.displacement), along(p, small_integer(c, 2), step.displacement)}, s}};
  });
  add("crossing", [](DrawStream& c) -> CapsulePair {
    const Point3d p = lattice_point_in_space(c, 12);
    const double r = up_to(c, 2), s = up_to(c, 2);
    return {{segment_through(c, p, lattice_normal(c, 4)), r}, {segment_through(c, p, lattice_normal(c, 4)), s}};
  });
  add("no_radius", [](DrawStream& c) -> CapsulePair {
    const LatticePlane plane = LatticePlane::of(c, 4);
    const double none = zero(c), other = up_to(c, 63);
    const bool both = c.one_in(4), first = c.coin();
    const Point3d p = plane.point(c, 2), q = plane.point(c, 2), r = plane.point(c, 2);
    return {{{p, q}, first || both ? none : other}, {{r, plane.point(c, 2)}, first && !both ? other : none}};
  });
  add("zero_length", [](DrawStream& c) -> CapsulePair {
    const Step step = integer_step(c);
    const Point3d p = lattice_point_in_space(c, 16), q = p + step.displacement;
    const auto [r, s] = reaching_radii(c, step.length);
    const bool both = c.coin(), first = c.coin();
    const Point3d on = both ? q : q + step.displacement;
    return first ? CapsulePair{{{p, p}, r}, {{q, on}, s}} : CapsulePair{{{q, on}, s}, {{p, p}, r}};
  });
  add("nearly_parallel", [](DrawStream& c) -> CapsulePair {
    const IntegerAcross across = IntegerAcross::of(c);
    const Point3d p = lattice_point_in_space(c, 12);
    const auto [r, s] = reaching_radii(c, across.length);
    Segment3d b = segment_through(c, p + across.displacement, across.u);
    b.b.x += small_integer(c, 1) * 0x1p-30;
    return {{segment_through(c, p, across.u), r}, {b, s}};
  });
  add("near_root", [](DrawStream& c) -> CapsulePair {
    const auto [x, r] = near_root(c);
    const double part = std::floor(x * up_to(c, 4) / 4), far = integer(c, 10);
    return {{{{0, 0, -4096}, {0, 0, 4096}}, part}, {{{r, r, far}, {2 * r, 2 * r, far}}, x - part}};
  });
  add("rounded_tangent", [](DrawStream& c) -> CapsulePair {
    const Point3d p = ordinary_point_in_space(c), a = ordinary_point_in_space(c);
    const Vector3d displacement = p - a;
    const double part = c.coin() ? 0.0 : std::fabs(ordinary(c)) * 0.25;
    return {{{p, along(p, 1, displacement)}, std::fabs(near_length(c, displacement) - part)},
            {{a, along(a, -1, displacement)}, part}};
  });
  add("sum_of_radii_rounds", [](DrawStream& c) -> CapsulePair {
    // The sum has digits that no double has; so has the distance, or not.
    const double r = 0x1p53 + 2 * static_cast<double>(c.below(1 << 20)), s = up_to(c, 3);
    const double off = small_integer(c, 1), far = up_to(c, 8);
    return {{{{r, 0, far}, {2 * r, 0, far}}, r}, {{{-s, 0, -8}, {-s, off, 8}}, s}};
  });
  add("off_by_a_hair", [](DrawStream& c) -> CapsulePair {
    const double r = scaled_up(c, 4, 1000), most = scaled_up(c, 4, 1000), s = c.coin() ? r : 0.0;
    const double y = c.coin() ? -r - s : r + s;
    return {{{{0, y, -most}, {0, y, most}}, r}, {{{-most, hair(c), 0}, {most, 0, 0}}, s}};
  });
  add("stretched", [](DrawStream& c) -> CapsulePair {
    const LatticePlane plane = LatticePlane::of(c);
    Point3d p = plane.point(c), q = plane.point(c), a = plane.point(c), b = plane.point(c);
    Stretch{c}(p, q, a, b);
    return {{{p, q}, scaled_down(c, 4, 300)}, {{a, b}, scaled_down(c, 4, 300)}};
  });
  add("typed_shapes", [](DrawStream& c) -> CapsulePair {
    const Point3d p = typed_point(c), q = typed_point(c), a = typed_point(c);
    return {{{p, q}, std::fabs(typed(c))}, {{a, {p.x, p.y + 0.5, p.z}}, std::fabs(typed(c))}};
  });
  add("subnormal", [](DrawStream& c) -> CapsulePair {
    const Point3d p = subnormal_point(c), q = subnormal_point(c), a = subnormal_point(c);
    const double r = std::ldexp(up_to(c, 5), -1074), s = std::ldexp(up_to(c, 5), -1074);
    return {{{p, q}, r}, {{a, c.coin() ? lattice_point_in_space(c, 4) : subnormal_point(c)}, s}};
  });
  add("whole_range", [](DrawStream& c) -> CapsulePair {
    const Point3d p = point_of_full_range(c), q = point_of_full_range(c), a = point_of_full_range(c),
                  b = point_of_full_range(c);
    return {{{p, q}, std::fabs(of_full_range(c))}, {{a, b}, std::fabs(of_full_range(c))}};
  });
  add("either_zero", [](DrawStream& c) -> CapsulePair {
    const Point3d p = zero_point(c), q = zero_point(c), a = zero_point(c), b = zero_point(c);
    const double r = c.coin() ? -0.0 : up_to(c, 1), s = c.coin() ? -0.0 : 1;
    return {{{p, q}, r}, {{a, c.coin() ? b : Point3d{1, b.y, b.z}}, s}};
  });
}

}  // namespace touchstone::catalogue
