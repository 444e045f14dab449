// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_sphere_plane.h"

#include "robust/kernel/enclosed_shapes.h"
#include "robust/kernel/plane_terms.h"
#include "robust/kernel/quadratic_root.h"
#include "robust/kernel/valid_space.h"
#include "robust/stages/sweeps/swept_sphere_plane.h"

namespace touchstone::robust {
namespace {

/// When a ball meets a plane first, as far as signs tell.
enum class Meeting { unknown, at_start, later, never };

double sum_of_sizes(double x, double y, double z) { return __builtin_fabs(x) + __builtin_fabs(y) + __builtin_fabs(z); }

/// What a few operations on doubles say, with u = 2^-52, which bounds a rounding in every mode.
///
/// E0 is the height of the center at the start, S what it gains, and R = r sqrt(N . N). Let n, p, v be the sums of the
/// magnitudes of the coordinates of N, of the center and of the velocity. E0 is off by less than 4 u (n p + |d|) (1 + 2
/// u), S by 3 u n v (1 + 2 u). N . N is off by 3 u of itself, so that R is off by 1.5 u, by u for the root and u for the
/// product: less than 4 u R. The start is decided by |E0| and R, whose difference cannot round to a wrong sign: 5 u (n p
/// + |d| + R) leaves a fifth for the bound's own roundings. The end is decided by that difference, rounded with u (n p +
/// |d| + R), and S, added or taken off: of 7 u (n (p + v) + |d| + R) two sevenths are left.
///
/// Guards: N . N in [2^-900, 2^900], so that what underflows in it is below 2^-100 u of it; n, p, v and r together at
/// most 2^500. Then reading a subnormal as zero costs a term less than 2^-1022 2^500, and everything together less than
/// 2^-510. An offset that makes a sum overflow leaves |E0| no greater than its bound: unknown. NaN fails each
/// comparison.
class Heights {
 public:
  Heights(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane) {
    const Vector3d& n = plane.normal;
    const Point3d& c = sphere.center;
    squares_ = n.x * n.x + n.y * n.y + n.z * n.z;
    height_ = n.x * c.x + n.y * c.y + n.z * c.z + plane.offset;
    rise_ = n.x * velocity.x + n.y * velocity.y + n.z * velocity.z;
    reach_ = sphere.radius * __builtin_sqrt(squares_);
    const double of_normal = sum_of_sizes(n.x, n.y, n.z), of_center = sum_of_sizes(c.x, c.y, c.z),
                 of_velocity = sum_of_sizes(velocity.x, velocity.y, velocity.z);
    at_start_ = of_normal * of_center + __builtin_fabs(plane.offset) + reach_;
    at_end_ = at_start_ + of_normal * of_velocity;
    size_ = of_normal + of_center + of_velocity + sphere.radius;
  }

  Meeting meeting() const {
    const bool guarded = squares_ >= 0x1p-900 && squares_ <= 0x1p900 && size_ <= 0x1p500;
    if (!guarded) return Meeting::unknown;
    const double gap = __builtin_fabs(height_) - reach_, error = 5 * u * at_start_ + least;
    if (gap < -error) return Meeting::at_start;
    if (!(gap > error)) return Meeting::unknown;
    const double last = gap + (behind() ? -rise_ : rise_), error_at_end = 7 * u * at_end_ + least;
    if (last > error_at_end) return Meeting::never;
    return last < -error_at_end ? Meeting::later : Meeting::unknown;
  }

  /// Where the meeting is certain and not at the start.
  bool behind() const { return height_ < 0; }

 private:
  static constexpr double u = 0x1p-52, least = 0x1p-500;
  double squares_, height_, rise_, reach_, at_start_, at_end_, size_;
};

/// E0 and S as integers times 2^exponent, and r^2 N . N as one times 2^(2 exponent).
struct Integers {
  mpz_class height, rise, squared_reach;

  Integers(const Sphere3d& sphere, const Vector3d& v, const Plane3d& plane) {
    using namespace kernel;
    const Vector3d& n = plane.normal;
    const Scaled<mpz_class> e = exact_sum(height_over(plane, sphere.center)),
                            s = exact_sum(std::array{term(n.x, v.x), term(n.y, v.y), term(n.z, v.z)}),
                            q = exact_sum(squared_normal(plane));
    const Term radius = term(sphere.radius);
    const mpz_class r = scaled(radius, 0);
    const int of_reach = q.exponent + 2 * radius.exponent,
              halved = of_reach >= 0 ? of_reach / 2 : -((1 - of_reach) / 2);
    const int exponent = std::min({e.exponent, s.exponent, halved});
    const auto in_units = [](const mpz_class& number, int shift) {
      return mpz_class(number << static_cast<unsigned long>(shift));
    };
    height = in_units(e.n, e.exponent - exponent), rise = in_units(s.n, s.exponent - exponent);
    squared_reach = in_units(q.n * r * r, of_reach - 2 * exponent);
  }
};

FirstContact<double> hit(double t) { return {HitRelation::hit, t}; }
const FirstContact<double> no_hit{HitRelation::never, std::nullopt};

void validate(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane) {
  if (kernel::valid(sphere) && kernel::valid(velocity) && kernel::valid(plane)) return;
  validation::validate("sphere", sphere), validation::validate("velocity", velocity);
  validation::validate("plane", plane);
}

}  // namespace

Perhaps<FirstContact<double>> stages::swept_sphere_plane::filter(const Sphere3d& sphere, const Vector3d& velocity,
                                                                 const Plane3d& plane) {
  if (kernel::sign_bit(sphere.radius)) return std::nullopt;  // -0.0, or for validation to refuse
  const Meeting meeting = Heights(sphere, velocity, plane).meeting();
  if (meeting == Meeting::at_start) return hit(0);
  if (meeting == Meeting::never) return no_hit;
  return std::nullopt;
}

Perhaps<FirstContact<double>> stages::swept_sphere_plane::enclosed(const Sphere3d& sphere, const Vector3d& velocity,
                                                                   const Plane3d& plane) {
  const Heights heights(sphere, velocity, plane);
  if (kernel::sign_bit(sphere.radius) || heights.meeting() != Meeting::later) return std::nullopt;
  using namespace kernel;
  const Vector3d &n = plane.normal, &v = velocity;
  const Point3d& c = sphere.center;
  const Two x(c.x, v.x), y(c.y, v.y), z(c.z, v.z), offset(plane.offset, 0);
  if (!in_window(x, y, z, offset, Two(n.x, n.y), Two(n.z, sphere.radius)) || !rounds_to_nearest()) return std::nullopt;
  const Vector3<Factor<Two>> normal = factors(n);
  const Enclosed<Two> height_and_rise = enclosed_heights(normal, offset, factors(x, y, z));
  Sum squares(product(first(normal.x), first(normal.x)));
  squares += product(first(normal.y), first(normal.y)), squares += product(first(normal.z), first(normal.z));
  const Enclosed<double> square = squares.value(), height = first(height_and_rise), rise = second(height_and_rise);
  if (!square.settled() || !height.settled() || !rise.settled()) return std::nullopt;
  const Enclosed<double> length = square_root(square);
  if (!length.settled()) return std::nullopt;
  const Enclosed<double> reach = Enclosed<double>{sphere.radius, 0, 0} * length,
                         gap = (heights.behind() ? -height : height) - reach;
  const auto t = rounded(gap / Divisor(heights.behind() ? rise : -rise));
  if (!t) return std::nullopt;
  return hit(*t);
}

/// With a center in front, E falls by -S: it is at the reach at (E0 - R) / -S. From behind the signs are turned.
FirstContact<double> stages::swept_sphere_plane::exact(const Sphere3d& sphere, const Vector3d& velocity,
                                                       const Plane3d& plane) {
  const Integers n(sphere, velocity, plane);
  const bool behind = sgn(n.height) < 0;
  const mpz_class start = abs(n.height), fall = behind ? n.rise : mpz_class(-n.rise), end = start - fall;
  if (kernel::sign_with_root(start, -1, n.squared_reach) <= 0) return hit(0);
  if (kernel::sign_with_root(end, -1, n.squared_reach) > 0) return no_hit;
  return hit(kernel::round_quadratic_root(start, -1, n.squared_reach, fall));
}

Decided<FirstContact<double>> stages::swept_sphere_plane::ask(const Sphere3d& sphere, const Vector3d& velocity,
                                                              const Plane3d& plane) {
  return in_turn<swept_sphere_plane, Stage::filter, Stage::enclosed, validate, Stage::exact>(sphere, velocity, plane);
}

FirstContact<double> swept_sphere_plane(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane) {
  return stages::swept_sphere_plane::ask(sphere, velocity, plane).answer;
}

}  // namespace touchstone::robust
