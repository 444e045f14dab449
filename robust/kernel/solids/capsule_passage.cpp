// SPDX-License-Identifier: Apache-2.0
#include <initializer_list>
#include <optional>

#include "robust/kernel/enclosed/loose.h"
#include "robust/kernel/enclosed/window.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/integers/quadratic_root.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/solids/ball_passage.h"

namespace touchstone::robust::kernel {
namespace {

/// The entries and exits of parts of a solid; compared by their bits, since a subnormal number may be read as zero.
struct Parts {
  std::optional<double> first{}, last{};

  void enters(double t) {
    if (!first || ordered_bits(t) < ordered_bits(*first)) first = t;
  }
  void leaves(double t) {
    if (!last || ordered_bits(t) > ordered_bits(*last)) last = t;
  }
  void add(const Passage<double>& part) {
    if (part.relation == PassageRelation::hit) enters(*part.first), leaves(*part.last);
  }
  Passage<double> together() const { return first ? Passage<double>{PassageRelation::hit, first, last} : no_passage; }
};

/// Empty if it is not certain.
std::optional<bool> all_positive(std::initializer_list<Loose> numbers) {
  bool known = true;
  for (const Loose& x : numbers) {
    if (!certain(x)) known = false;
    else if (x.high < 0) return false;
  }
  return known ? std::optional(true) : std::nullopt;
}

Perhaps<Passage<double>> ball_if_certain(const Line& line, const Point3d& end, double radius) {
  const Ball ball(Sphere3d{end, radius});
  if (const auto missed = BallPassage::filter(line, ball)) return missed;
  return BallPassage::enclosed(line, ball);
}

}  // namespace

/// With p, w and v the displacements from an end of the axis to the line's start, along the axis and along the line:
/// the squared distance from the axis, times w . w, is |w x p + t (w x v)|^2. With n = w x v, h = n . (w x p) and c =
/// |w x p|^2 - r^2 w . w the cylinder is where n . n t^2 + 2 h t + c <= 0, and h^2 - c n . n = w . w (r^2 n . n - (p .
/// n)^2). A t is between the ends of the axis if 0 <= p . w + t v . w <= w . w.
///
/// Underflow: the numbers of the discriminant have the degree 8, and are, as in sized.h, multiples of 2^-656 below
/// 2^260. Its root lies between 2^-328 and 2^130, a quotient between 2^-464 and 2^464; what is left of either is a
/// multiple of 2^-818, and only products with it may underflow: by less than 2^-1022, of which the bounds, E of a
/// quotient or of its product with v . w, have plenty to spare. Not proved by machine.
Perhaps<Passage<double>> CapsulePassage::enclosed(const Line& line, const Capsule3d& capsule) {
  using filters::moderate;
  const auto& [from, to, ends] = line;
  const auto& [a, b] = capsule.segment;
  const double r = capsule.radius;
  if (!(moderate(from) & moderate(to) & moderate(capsule.segment) & moderate(r))) return std::nullopt;
  if (sign_bit(r) || !rounds_to_nearest()) return std::nullopt;
  const auto ball_a = ball_if_certain(line, a, r), ball_b = ball_if_certain(line, b, r);
  if (!ball_a || !ball_b) return std::nullopt;
  Parts parts;
  parts.add(*ball_a), parts.add(*ball_b);
  const auto p = loose_between(a, from), w = loose_between(a, b),
             v = ends ? loose_between(from, to) : loose({to.x, to.y, to.z});
  const auto n = cross(w, v), m = cross(w, p);
  const Loose length = dot(w, w), start = dot(p, w), climb = dot(v, w), square = dot(n, n), half = dot(n, m),
              reach = Loose(r) * Loose(r), constant = dot(m, m) - reach * length;
  if (none_of(length)) return parts.together();
  const auto starts_inside = all_positive({start, length - start, -constant});
  if (!starts_inside) return std::nullopt;
  if (*starts_inside) parts.enters(0);
  if (ends) {
    const Loose end = start + climb, constant_at_end = constant + half + (half + square);
    const auto ends_inside = all_positive({end, length - end, -constant_at_end});
    if (!ends_inside) return std::nullopt;
    if (*ends_inside) parts.leaves(1);
  }
  if (none_of(square)) return parts.together();
  const Loose height = dot(p, n), within = reach * square - height * height;
  if (!certain(square) || !certain(within)) return std::nullopt;
  if (within.high < 0) return parts.together();
  const Loose discriminant = length * within;
  if (!certain(discriminant)) return std::nullopt;
  const bool ahead = half.high < 0;
  const Loose sum = Loose(square_root(discriminant)) + (ahead ? -half : half);
  if (!certain(sum)) return std::nullopt;
  const Divisor<double> by_sum(sum), by_square(square);
  const Loose entry = ahead ? constant / by_sum : -sum / by_square, exit = ahead ? sum / by_square : -constant / by_sum;
  for (const Loose* t : {&entry, &exit}) {
    const Loose at = start + *t * climb;
    const auto counts = all_positive({*t, ends ? Loose(1) - *t : Loose(1), at, length - at});
    if (!counts) return std::nullopt;
    if (!*counts) continue;
    const auto number = rounded(*t);
    if (!number) return std::nullopt;
    t == &entry ? parts.enters(*number) : parts.leaves(*number);
  }
  return parts.together();
}

Passage<double> CapsulePassage::exact(const Line& line, const Capsule3d& capsule) {
  const auto& [a, b] = capsule.segment;
  Parts parts;
  for (const Point3d& end : {a, b}) parts.add(BallPassage::exact(line, Sphere3d{end, capsule.radius}));
  const Point3d base = line.ends ? line.from : Point3d{0, 0, 0};
  const auto at = integer_points(a, b, line.from, line.to, base, Point3d{capsule.radius, 0, 0}).at;
  const Vector3<mpz_class> p = at[2] - at[0], w = at[1] - at[0], v = at[3] - at[4], n = cross(w, v), m = cross(w, p);
  const mpz_class length = dot(w, w), start = dot(p, w), climb = dot(v, w), square = dot(n, n), half = dot(n, m),
                  reach = at[5].x * at[5].x, constant = dot(m, m) - reach * length;
  if (sgn(length) == 0) return parts.together();
  const auto between = [&length](const mpz_class& x) { return sgn(x) >= 0 && x <= length; };
  if (between(start) && sgn(constant) <= 0) parts.enters(0);
  const mpz_class constant_at_end = constant + 2 * half + square;
  if (line.ends && between(start + climb) && sgn(constant_at_end) <= 0) parts.leaves(sgn(dot(v, v)) != 0 ? 1.0 : 0.0);
  const mpz_class height = dot(p, n), discriminant = length * (reach * square - height * height);
  if (sgn(square) == 0 || sgn(discriminant) < 0) return parts.together();
  for (const int side : {-1, 1}) {
    // The signs of t, 1 - t, the place along the axis and what is beyond it, all of them times n . n.
    const mpz_class along = start * square - climb * half, root = climb * climb * discriminant;
    const int upwards = side * (sgn(climb) < 0 ? -1 : 1);
    const bool counts = sign_with_root(-half, side, discriminant) >= 0 &&
                        (!line.ends || sign_with_root(square + half, -side, discriminant) >= 0) &&
                        sign_with_root(along, upwards, root) >= 0 &&
                        sign_with_root(length * square - along, -upwards, root) >= 0;
    if (!counts) continue;
    const double t = round_quadratic_root(-half, side, discriminant, square);
    side < 0 ? parts.enters(t) : parts.leaves(t);
  }
  return parts.together();
}

}  // namespace touchstone::robust::kernel
