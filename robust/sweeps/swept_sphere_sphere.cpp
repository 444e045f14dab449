// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_sphere_sphere.h"

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/filters/sweep_filter.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/quadratic_root.h"
#include "robust/kernel/integers/term_sum.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using filters::Sign;

/// The time at which two moving spheres first meet, as far as signs decide it.
enum class Passage { at_start, later, never };

/// The certain result of the filter, `later` by its end or by the line of the sweep.
std::optional<Passage> meeting_by_filter(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                         const Vector3d& velocity_b) {
  if (kernel::sign_bit(a.radius) || kernel::sign_bit(b.radius))
    return std::nullopt;  // -0.0, or negative, which validation refuses
  const filters::Sweep<double> sweep(a, b, velocity_a, velocity_b);
  const Sign start = sweep.start();
  if (start == Sign::negative) return Passage::at_start;
  if (start == Sign::unknown) return std::nullopt;
  const Sign slope = sweep.slope_at_start();
  if (slope == Sign::positive) return Passage::never;
  const Sign end = sweep.end();
  if (end == Sign::negative) return Passage::later;
  const Sign slope_at_end = sweep.slope_at_end();
  if (end == Sign::positive && slope_at_end == Sign::negative) return Passage::never;
  const Sign passage = sweep.passage();
  if (passage == Sign::positive) return Passage::never;
  const bool turns = slope == Sign::negative && slope_at_end == Sign::positive;
  if (turns && passage == Sign::negative) return Passage::later;
  return std::nullopt;
}

}  // namespace

Perhaps<FirstContact<double>> stages::swept_sphere_sphere::filter(const Sphere3d& a, const Sphere3d& b,
                                                                  const Vector3d& va, const Vector3d& vb) {
  const auto passage = meeting_by_filter(a, b, va, vb);
  if (passage == Passage::never) return FirstContact<double>{HitRelation::never, std::nullopt};
  if (passage == Passage::at_start) return FirstContact<double>{HitRelation::hit, 0.0};
  return std::nullopt;
}

/// The smaller zero of f if the filter says that the spheres meet after the start: the root is computed where its terms
/// have the same sign.
Perhaps<FirstContact<double>> stages::swept_sphere_sphere::enclosed(const Sphere3d& a, const Sphere3d& b,
                                                                    const Vector3d& va, const Vector3d& vb) {
  if (meeting_by_filter(a, b, va, vb) != Passage::later) return std::nullopt;
  using namespace kernel;
  const Point3d &ca = a.center, &cb = b.center;
  // Position and velocity, one per lane.
  const Vector3<Two> of_a{Two(ca.x, va.x), Two(ca.y, va.y), Two(ca.z, va.z)},
      of_b{Two(cb.x, vb.x), Two(cb.y, vb.y), Two(cb.z, vb.z)};
  const Two radii(a.radius, b.radius);
  if (!in_window(of_a.x, of_a.y, of_a.z, of_b.x, of_b.y, of_b.z, radii) || !rounds_to_nearest()) return std::nullopt;
  const Factor<Two> x = vector_between(of_b.x, of_a.x), y = vector_between(of_b.y, of_a.y),
                    z = vector_between(of_b.z, of_a.z);
  const Factor<double> reach = factor(two_sum(a.radius, b.radius));
  Sum<Two> squares(kernel::product(x, x));
  squares += kernel::product(y, y), squares += kernel::product(z, z);
  Sum<double> slope(kernel::product(first(x), second(x)));
  slope += kernel::product(first(y), second(y)), slope += kernel::product(first(z), second(z));
  const Enclosed<Two> distance_and_speed = squares.value();
  const Enclosed<double> half_slope = slope.value(), speed = second(distance_and_speed),
                         gap = first(distance_and_speed) - Sum(kernel::product(reach, reach)).value();
  if (!half_slope.settled() || !speed.settled() || !gap.settled()) return std::nullopt;
  const Enclosed<double> discriminant = half_slope * half_slope - speed * gap;
  if (!discriminant.settled() || !(half_slope.high < 0 && discriminant.high > 0)) return std::nullopt;
  const Enclosed<double> below = square_root(discriminant) - half_slope;
  if (!below.settled()) return std::nullopt;
  const auto t = rounded(gap / Divisor(below));
  if (!t) return std::nullopt;
  return FirstContact<double>{HitRelation::hit, t};
}

namespace {

using kernel::Int128;
using kernel::UInt128;

/// The square of a length, which on a lattice is below 3 2^126.
UInt128 square(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto of = [](std::int64_t n) { return static_cast<UInt128>(static_cast<Int128>(n) * n); };
  return of(x) + of(y) + of(z);
}
mpz_class square(const mpz_class& x, const mpz_class& y, const mpz_class& z) { return x * x + y * y + z * z; }

Int128 product(const Vector3<std::int64_t>& v, const Vector3<std::int64_t>& w) {
  const auto of = [](std::int64_t a, std::int64_t b) { return static_cast<Int128>(a) * b; };
  return of(v.x, w.x) + of(v.y, w.y) + of(v.z, w.z);
}
mpz_class product(const Vector3<mpz_class>& v, const Vector3<mpz_class>& w) { return dot(v, w); }

int order(const UInt128& a, const UInt128& b) { return (a > b) - (a < b); }
int order(const mpz_class& a, const mpz_class& b) { return cmp(a, b); }

mpz_class integer_of(const UInt128& n) { return kernel::scaled(kernel::Term{n, 0, false}, 0); }
mpz_class integer_of(const Int128& n) { return kernel::integer_of(n); }
const mpz_class& integer_of(const mpz_class& n) { return n; }

/// The sign of product^2 - first (second - third), second >= third.
int discriminant_sign(const Int128& product, const UInt128& first, const UInt128& second, const UInt128& third) {
  const UInt128 size = kernel::magnitude_of(product);
  return kernel::compare_products(size, size, first, second - third);
}
int discriminant_sign(const mpz_class& product, const mpz_class& first, const mpz_class& second,
                      const mpz_class& third) {
  return sgn(mpz_class(product * product - first * (second - third)));
}

/// The sweep as integers over one power of two: std::int64_t on a lattice, where positions and velocities are below
/// 2^62, so that sums of three products of them, and the squares of a's position at the end, fit 128 bits; or
/// mpz_class.
template <class Integer>
class Motion {
 public:
  template <class Numbers>
  explicit Motion(const Numbers& n)
      : position_{n[0] - n[4], n[1] - n[5], n[2] - n[6]},
        velocity_{n[8] - n[11], n[9] - n[12], n[10] - n[13]},
        radii_(square(Integer(n[3] + n[7]), Integer(0), Integer(0))) {}

  /// f(t) = |position + t velocity|^2 - radii falls as long as position . velocity + t velocity . velocity < 0.
  Passage passage() const {
    const Vector3<Integer>&p = position_, &v = velocity_;
    const auto distance = square(p.x, p.y, p.z);
    if (order(distance, radii_) <= 0) return Passage::at_start;
    const auto half_slope = product(p, v);
    if (kernel::sign_of(half_slope) >= 0) return Passage::never;
    const Vector3<Integer> last{p.x + v.x, p.y + v.y, p.z + v.z};
    if (order(square(last.x, last.y, last.z), radii_) <= 0) return Passage::later;
    if (kernel::sign_of(product(last, v)) <= 0) return Passage::never;
    const bool passes = discriminant_sign(half_slope, square(v.x, v.y, v.z), distance, radii_) < 0;
    return passes ? Passage::never : Passage::later;
  }

  /// The smaller zero of f.
  double first_zero() const {
    const Vector3<Integer>&p = position_, &v = velocity_;
    const mpz_class half_slope = integer_of(product(p, v)), speed = integer_of(square(v.x, v.y, v.z));
    const mpz_class gap = integer_of(square(p.x, p.y, p.z)) - integer_of(radii_);
    return kernel::round_quadratic_root(-half_slope, -1, half_slope * half_slope - speed * gap, speed);
  }

  FirstContact<double> contact() const {
    const Passage m = passage();
    if (m == Passage::never) return {HitRelation::never, std::nullopt};
    return {HitRelation::hit, m == Passage::at_start ? 0.0 : first_zero()};
  }

 private:
  Vector3<Integer> position_, velocity_;
  decltype(square(Integer(), Integer(), Integer())) radii_;
};

std::optional<Motion<std::int64_t>> on_lattice(const Sphere3d& a, const Sphere3d& b, const Vector3d& va,
                                               const Vector3d& vb) {
  const auto lattice = kernel::lattice_of(a.center.x, a.center.y, a.center.z, a.radius, b.center.x, b.center.y,
                                          b.center.z, b.radius, va.x, va.y, va.z, vb.x, vb.y, vb.z);
  if (!lattice) return std::nullopt;
  return Motion<std::int64_t>(lattice->at);
}

Motion<mpz_class> on_integers(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb) {
  return Motion<mpz_class>(kernel::integers_of(a.center.x, a.center.y, a.center.z, a.radius, b.center.x, b.center.y,
                                               b.center.z, b.radius, va.x, va.y, va.z, vb.x, vb.y, vb.z)
                               .at);
}

void validate_swept_sphere_sphere(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                  const Vector3d& velocity_b) {
  if (kernel::valid(a) && kernel::valid(b) && kernel::valid(velocity_a) && kernel::valid(velocity_b)) return;
  validation::validate_all("a", a, "b", b, "velocity_a", velocity_a, "velocity_b", velocity_b);
}

}  // namespace

Perhaps<FirstContact<double>> stages::swept_sphere_sphere::lattice(const Sphere3d& a, const Sphere3d& b,
                                                                   const Vector3d& va, const Vector3d& vb) {
  const auto motion = on_lattice(a, b, va, vb);
  if (!motion) return std::nullopt;
  return motion->contact();
}

FirstContact<double> stages::swept_sphere_sphere::exact(const Sphere3d& a, const Sphere3d& b, const Vector3d& va,
                                                        const Vector3d& vb) {
  return on_integers(a, b, va, vb).contact();
}

Decided<FirstContact<double>> stages::swept_sphere_sphere::ask(const Sphere3d& a, const Sphere3d& b, const Vector3d& va,
                                                               const Vector3d& vb) {
  return in_turn<swept_sphere_sphere, Stage::filter, Stage::enclosed, validate_swept_sphere_sphere, Stage::lattice,
                 Stage::exact>(a, b, va, vb);
}

FirstContact<double> swept_sphere_sphere(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                         const Vector3d& velocity_b) {
  return stages::swept_sphere_sphere::ask(a, b, velocity_a, velocity_b).answer;
}

namespace {

HitRelation relation_of(Passage passage) { return passage == Passage::never ? HitRelation::never : HitRelation::hit; }

}  // namespace

Perhaps<HitRelation> stages::swept_sphere_sphere::decision::filter(const Sphere3d& a, const Sphere3d& b,
                                                                   const Vector3d& va, const Vector3d& vb) {
  const auto passage = meeting_by_filter(a, b, va, vb);
  if (!passage) return std::nullopt;
  return relation_of(*passage);
}

Perhaps<HitRelation> stages::swept_sphere_sphere::decision::lattice(const Sphere3d& a, const Sphere3d& b,
                                                                    const Vector3d& va, const Vector3d& vb) {
  const auto motion = on_lattice(a, b, va, vb);
  if (!motion) return std::nullopt;
  return relation_of(motion->passage());
}

HitRelation stages::swept_sphere_sphere::decision::exact(const Sphere3d& a, const Sphere3d& b, const Vector3d& va,
                                                         const Vector3d& vb) {
  return relation_of(on_integers(a, b, va, vb).passage());
}

Decided<HitRelation> stages::swept_sphere_sphere::decision::ask(const Sphere3d& a, const Sphere3d& b,
                                                                const Vector3d& va, const Vector3d& vb) {
  return in_turn<decision, Stage::filter, validate_swept_sphere_sphere, Stage::lattice, Stage::exact>(a, b, va, vb);
}

HitRelation swept_sphere_sphere_relation(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                         const Vector3d& velocity_b) {
  return stages::swept_sphere_sphere::decision::ask(a, b, velocity_a, velocity_b).answer;
}

}  // namespace touchstone::robust
