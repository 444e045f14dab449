// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/ball_passage.h"

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/filters/sweep_filter.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/quadratic_root.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust::kernel {
namespace {

/// The point that is subtracted from `to` to get the direction.
Point3d base_of(const Line& line) { return line.ends ? line.from : Point3d{0, 0, 0}; }

Vector3d vector_of(const Point3d& p) { return {p.x, p.y, p.z}; }

}  // namespace

Perhaps<Passage<double>> BallPassage::filter(const Line& line, const Ball& ball) {
  using filters::Sign;
  if (sign_bit(ball.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
  const filters::Sweep<double> sweep({line.from, 0}, ball, vector_of(line.to), vector_of(base_of(line)));
  if (sweep.start() != Sign::positive) return std::nullopt;
  if (sweep.slope_at_start() == Sign::positive || sweep.passage() == Sign::positive) return no_passage;
  if (line.ends && sweep.end() == Sign::positive && sweep.slope_at_end() == Sign::negative) return no_passage;
  return std::nullopt;
}

/// Each root is computed where its terms have the same sign: with s the root of the discriminant and h half the slope
/// of f at the start, the smaller zero is f(0) / (s - h) and the greater (s - h) / v . v if h < 0; if h > 0 the greater
/// is -f(0) / (s + h).
Perhaps<Passage<double>> BallPassage::enclosed(const Line& line, const Ball& ball) {
  const Point3d &p = line.from, &c = ball.center, &to = line.to, base = base_of(line);
  // Position and direction, one per lane.
  const Vector3<Two> of_line{Two(p.x, to.x), Two(p.y, to.y), Two(p.z, to.z)},
      of_ball{Two(c.x, base.x), Two(c.y, base.y), Two(c.z, base.z)};
  if (sign_bit(ball.radius) || !rounds_to_nearest()) return std::nullopt;
  if (!in_window(of_line.x, of_line.y, of_line.z, of_ball.x, of_ball.y, of_ball.z, Two(ball.radius)))
    return std::nullopt;
  const Factor<Two> x = vector_between(of_ball.x, of_line.x), y = vector_between(of_ball.y, of_line.y),
                    z = vector_between(of_ball.z, of_line.z);
  const Factor<double> radius = factor(ball.radius);
  Sum<Two> squares(product(x, x));
  squares += product(y, y), squares += product(z, z);
  Sum<double> slope(product(first(x), second(x)));
  slope += product(first(y), second(y)), slope += product(first(z), second(z));
  const Enclosed<Two> distance_and_speed = squares.value();
  const Enclosed<double> half = slope.value(), speed = second(distance_and_speed),
                         start = first(distance_and_speed) - Sum(product(radius, radius)).value();
  if (!half.settled() || !speed.settled() || !start.settled() || half.high == 0 || start.high == 0) return std::nullopt;
  const bool outside = start.high > 0, ahead = half.high < 0;
  if (outside && !ahead) return no_passage;
  const Enclosed<double> discriminant = half * half - speed * start;
  if (!discriminant.settled() || !(discriminant.high > 0)) return std::nullopt;
  const Enclosed<double> sum = square_root(discriminant) + (ahead ? -half : half);
  if (!sum.settled()) return std::nullopt;
  bool ends_inside = false;
  if (line.ends) {
    const Enclosed<double> slope_at_end = half + speed, end = (start + half) + slope_at_end;
    if (!end.settled() || end.high == 0) return std::nullopt;
    ends_inside = end.high < 0;
    if (outside && !ends_inside) {
      if (!slope_at_end.settled()) return std::nullopt;
      if (slope_at_end.high <= 0) return no_passage;
    }
  }
  const auto one = outside ? rounded(start / Divisor(sum)) : std::optional(0.0);
  const auto other = ends_inside ? std::optional(1.0) : rounded(ahead ? sum / Divisor(speed) : -start / Divisor(sum));
  if (!one || !other) return std::nullopt;
  return Passage<double>{PassageRelation::hit, *one, *other};
}

Passage<double> BallPassage::exact(const Line& line, const Ball& ball) {
  const Point3d &from = line.from, &center = ball.center, &to = line.to, base = base_of(line);
  const auto n = integers_of(from.x, from.y, from.z, center.x, center.y, center.z, to.x, to.y, to.z, base.x, base.y,
                             base.z, ball.radius)
                     .at;
  const Vector3<mpz_class> p{n[0] - n[3], n[1] - n[4], n[2] - n[5]}, v{n[6] - n[9], n[7] - n[10], n[8] - n[11]};
  const mpz_class start = dot(p, p) - n[12] * n[12], half = dot(p, v), speed = dot(v, v);
  const bool inside = sgn(start) <= 0;
  if (sgn(speed) == 0) return inside ? Passage<double>{PassageRelation::hit, 0.0, 0.0} : no_passage;
  const mpz_class discriminant = half * half - speed * start, end = start + 2 * half + speed;
  const bool ends_inside = line.ends && sgn(end) <= 0;
  if (!inside) {
    const bool falls_short = line.ends && !ends_inside && sgn(mpz_class(half + speed)) <= 0;
    if (sgn(half) >= 0 || sgn(discriminant) < 0 || falls_short) return no_passage;
  }
  const auto root = [&](int sign) { return round_quadratic_root(-half, sign, discriminant, speed); };
  return {PassageRelation::hit, inside ? 0.0 : root(-1), ends_inside ? 1.0 : root(1)};
}

}  // namespace touchstone::robust::kernel
