// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/space_draws.h"
#include "catalogue/families/whole_steps.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/sphere_sphere.h"
#include "oracle/volumes/sphere_sphere.h"
#include "reference/volumes/sphere_sphere.h"
#include "robust/batch/sphere_sphere.h"
#include "robust/volumes/sphere_sphere.h"

namespace touchstone::catalogue::rows {

struct sphere_sphere : signatures::sphere_sphere {
  TOUCHSTONE_STAGED_MODULES(sphere_sphere)
  TOUCHSTONE_ARRAYS(sphere_sphere)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "volumes",
                                     .pages = "44",
                                     .question = "Do the two balls, or discs, overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"a", "b"},
                                     .answer = "contact",
                                     .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("tangent", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const double r = part_of(step.length, c);
      return apart_by(step, r, step.length - r, c);
    });
    add("beside_tangent", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const double r = part_of(step.length, c);
      return apart_by(step, r, std::fabs(step.length - r + small_integer(c, 1)), c);
    });
    add("tangent_inside", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const double r = up_to(c, 7);
      return apart_by(step, r, r + step.length + small_integer(c, 1), c);
    });
    add("concentric", [](DrawStream& c) -> Question {
      const double r = up_to(c, 3), s = up_to(c, 3);
      return apart_by({{0, 0, 0}, 0, c.coin()}, r, s, c);
    });
    add("point_inside", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      return apart_by(step, 0, step.length + small_integer(c, 3), c);
    });
    add("points", [](DrawStream& c) -> Question {
      return apart_by({{small_integer(c, 1), small_integer(c, 1), 0}, 0, c.coin()}, 0, 0, c);
    });
    add("long_tangent", [](DrawStream& c) -> Question {
      // A multiple of 3, 4, 5 whose squares do not fit a double.
      const double w = 0x1p49 + static_cast<double>(c.below(std::uint64_t{1} << 49)), r = part_of(5 * w, c);
      const Step step{{3 * w, c.coin() ? -4 * w : 4 * w, 0}, 5 * w, c.coin()};
      return seen({{0, 0, 0}, r}, {at(step), 5 * w - r}, step.in_plane, c);
    });
    add("far_below", [](DrawStream& c) -> Question {
      // Tangent balls, one of them as large as the lattice just holds next to the other, or larger; or aside by a
      // hair.
      const double large = power_of_two(c, 50, 69),
                   larger = c.coin() ? std::ldexp(large, integer_in(c, 0, 899)) : large;
      const double m = one_to(c, 3), s = m + small_integer(c, 1);
      const double side = small_integer(c, 1), hair = std::ldexp(side, -integer_in(c, 0, 1073));
      return seen({{-larger, 0, 0}, larger}, {{m, hair, 0}, s}, c);
    });
    add("rounded_tangent", [](DrawStream& c) -> Question {
      const auto position = [&c] {
        const double x = ordinary(c), y = ordinary(c);
        return Point3d{x, y, ordinary(c)};
      };
      const bool plane = c.coin();
      Point3d p = position(), q = position();
      if (plane) p.z = q.z = 0;
      const Vector3d v = q - p;
      const double distance = std::sqrt(dot(v, v)), r = distance * up_to(c, 8) / 8;
      return seen({p, r}, {q, std::fabs(moved_by_ulps(distance - r, integer_in(c, -3, 3)))}, plane, c);
    });
    add("much_rounded", [](DrawStream& c) -> Question {
      // One position and one radius just above a power of two, the others far smaller: differences and sums round
      // by all they may.
      const auto large = [&c] { return 1 + up_to(c, 2) * 0x1p-52; };
      const auto small = [&c] { return up_to(c, 255) * 0x1p-60; };
      const double x = large(), r = large(), y = small(), s = small();
      const int e = integer_in(c, -300, 300);
      const double sign = either_sign(c);
      return seen({{std::ldexp(x, e), 0, 0}, std::ldexp(s, e)}, {{std::ldexp(sign * y, e), 0, 0}, std::ldexp(r, e)}, c);
    });
    add("subnormal", [](DrawStream& c) -> Question {
      // Near the least normal number, and at the origin.
      const auto least = [&c] { return std::ldexp(up_to(c, 5), -1074); };
      const double from = c.coin() ? 0x1p-1021 : 0.0, x = least(), y = least(), r = least(), s = least();
      return seen({{from, 0, 0}, r}, {{from + x, y, 0}, s}, c);
    });
    add("least_radius", [](DrawStream& c) -> Question {
      // A point, or a ball as small as can be, in another: only one of them has an interior.
      const double r = std::ldexp(up_to(c, 2), -1074), x = small_integer(c, 2);
      return seen({{x, 0, 0}, r}, {{0, 0, 0}, one_to(c, 2)}, c);
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const double x = zero(c), y = zero(c), r = zero(c), s = zero(c), more = up_to(c, 1), aside = small_integer(c, 1);
      return seen({{x, 0, 0}, r}, {{aside == 0 ? y : aside, 0, 0}, more == 0 ? s : more}, c);
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const auto half = [&c] { return std::ldexp(one_to(c, 2), 1022); };
      const double r = half(), s = c.coin() ? half() : greatest_double;
      const double x = c.coin() ? -half() : -greatest_double, y = c.coin() ? 0.0 : half(), aside = small_integer(c, 1);
      return seen({{x, 0, 0}, r}, {{y, aside, 0}, s}, c);
    });
    add("typed_touch", [](DrawStream& c) -> Question {
      // As typed they touch.
      const double k = one_to(c, 9), m = one_to(c, 9);
      const double scale = one_to(c, 2);
      return seen({{0, 0, 0}, k / 10}, {{3 * scale * (k + m) / 50, 4 * scale * (k + m) / 50, 0}, m / 10}, c);
    });
  }

  /// Radii lose their sign.
  static void repair(Question& question) {
    std::visit(
        [](auto& solids) {
          auto& [a, b] = solids;
          a.radius = std::fabs(a.radius), b.radius = std::fabs(b.radius);
        },
        question);
  }

  /// Two discs that touch, by the triple 3, 4, 5; moves the center of the first.
  static Question map_centre() { return InPlane{{{0.5, 0.5}, 8}, {{12.5, 16.5}, 12}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<sphere_sphere> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::similarities, .scales = true, .exchanges = {{0, 1}}}};
  }

 private:
  /// From nothing to all of an integer length.
  static double part_of(double length, DrawStream& c) {
    return static_cast<double>(c.below(static_cast<std::uint64_t>(length) + 1));
  }

  static Point3d at(const Step& step) { return {step.displacement.x, step.displacement.y, step.displacement.z}; }

  /// From a lattice point.
  static Question apart_by(const Step& step, double r, double s, DrawStream& c) {
    Point3d p = lattice_point_in_space(c);
    if (step.in_plane) p.z = 0;
    return seen({p, std::fabs(r)}, {p + step.displacement, std::fabs(s)}, step.in_plane, c);
  }

  /// In space, or the same without z; in either order.
  static Question seen(const Sphere3d& a, const Sphere3d& b, bool in_plane, DrawStream& c) {
    if (c.coin()) return in_order(b, a, in_plane);
    return in_order(a, b, in_plane);
  }
  /// Centers with z = 0: either.
  static Question seen(const Sphere3d& a, const Sphere3d& b, DrawStream& c) { return seen(a, b, c.coin(), c); }
  static Question in_order(const Sphere3d& a, const Sphere3d& b, bool in_plane) {
    if (!in_plane) return InSpace{a, b};
    return InPlane{{{a.center.x, a.center.y}, a.radius}, {{b.center.x, b.center.y}, b.radius}};
  }
};

}  // namespace touchstone::catalogue::rows
