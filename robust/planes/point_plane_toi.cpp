// SPDX-License-Identifier: Apache-2.0
#include "robust/planes/point_plane_toi.h"

#include <cstdint>

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/filters/plane_filter.h"
#include "robust/kernel/integers/plane_terms.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// Turns -0.0 into 0, in every environment.
double positive_zero(double x) { return validation::zero(x) ? 0.0 : x; }

FirstHit<double> at_start(const Point3d& start) {
  return {HitRelation::hit, 0.0, Point3d{positive_zero(start.x), positive_zero(start.y), positive_zero(start.z)}};
}

const FirstHit<double> no_hit{HitRelation::never, std::nullopt, std::nullopt};

StepTest at_end(int sign) { return {sign <= 0 ? HitRelation::hit : HitRelation::never}; }

}  // namespace

Perhaps<PointPlaneToi<double>> stages::point_plane_toi::filter(const Plane3d& plane, const Point3d& start,
                                                               const Point3d& end) {
  const filters::Sign first = filters::plane(plane, start), last = filters::plane(plane, end);
  if (first == filters::Sign::unknown || last == filters::Sign::unknown) return std::nullopt;
  const int sign = last == filters::Sign::positive ? 1 : -1;
  if (first == filters::Sign::negative) return PointPlaneToi<double>{at_end(sign), at_start(start)};
  if (last == filters::Sign::positive) return PointPlaneToi<double>{at_end(sign), no_hit};
  return std::nullopt;
}

Perhaps<PointPlaneToi<double>> stages::point_plane_toi::enclosed(const Plane3d& plane, const Point3d& start,
                                                                 const Point3d& end) {
  using namespace kernel;
  const Vector3d& n = plane.normal;
  const Two x(start.x, end.x), y(start.y, end.y), z(start.z, end.z);
  if (!in_window(Two(n.x, n.y), Two(n.z, plane.offset), x, y, z) || !rounds_to_nearest()) return std::nullopt;
  const Enclosed<Two> heights = enclosed_heights(factors(n), Two(plane.offset), factors(x, y, z));
  const Enclosed<double> e0 = first(heights), e1 = second(heights), descent = e0 - e1;
  if (!heights.settled() || !descent.settled() || !(e0.high > 0 && e1.high < 0)) return std::nullopt;
  const Enclosed<double> t = e0 / Divisor(descent);
  const Two xy(start.x, start.y);
  const auto parameter = rounded(t);
  const auto there = rounded(along(xy, twice(t), vector_between(xy, Two(end.x, end.y))));
  const auto up = rounded(along(start.z, t, factor(difference(end.z, start.z))));
  if (!parameter || !there || !up) return std::nullopt;
  return PointPlaneToi<double>{at_end(-1),
                               {HitRelation::hit, parameter, Point3d{there->first(), there->second(), *up}}};
}

namespace {

using kernel::Int128;

/// (e0 end - e1 start) / (e0 - e1): the weights of both ends.
template <class Second, class Integer>
double between(const Second& e0, const Second& e1, const Integer& start, const Integer& end, int exponent) {
  using kernel::multiply;
  return kernel::round_quotient(multiply(e0, end) + multiply(Second(-e1), start), Second(e0 - e1), exponent);
}

/// The ends of the step as integers over one power of two: x, y, z of start, then of end.
template <class Second, class Numbers>
PointPlaneToi<double> answer_of(const Second& e0, const Second& e1, const Point3d& start, const Numbers& ends) {
  if (kernel::sign_of(e0) <= 0) return {at_end(kernel::sign_of(e1)), at_start(start)};
  if (kernel::sign_of(e1) > 0) return {at_end(1), no_hit};
  const auto coordinate = [&](std::size_t axis) {
    return between(e0, e1, ends.at[axis], ends.at[axis + 3], ends.exponent);
  };
  return {at_end(kernel::sign_of(e1)),
          {HitRelation::hit, kernel::round_quotient(e0, Second(e0 - e1)),
           Point3d{coordinate(0), coordinate(1), coordinate(2)}}};
}

/// The same number in units of 2^exponent; empty if that is not below 2^124, so that differences and their products
/// with a lattice fit.
std::optional<Int128> in_units(const kernel::Scaled<Int128>& x, int exponent) {
  const int shift = x.n == 0 ? 0 : x.exponent - exponent;
  if (kernel::bit_width(kernel::magnitude_of(x.n)) + shift > 124) return std::nullopt;
  return x.n * (Int128{1} << shift);
}

void validate_point_plane_toi(const Plane3d& plane, const Point3d& start, const Point3d& end) {
  if (kernel::valid(plane) && kernel::valid(start) && kernel::valid(end)) return;
  validation::validate_all("plane", plane, "start", start, "end", end);
}

}  // namespace

Perhaps<PointPlaneToi<double>> stages::point_plane_toi::lattice(const Plane3d& plane, const Point3d& start,
                                                                const Point3d& end) {
  const auto first = kernel::lattice_sum(kernel::height_over(plane, start)),
             last = kernel::lattice_sum(kernel::height_over(plane, end));
  const auto ends = kernel::lattice_of(start.x, start.y, start.z, end.x, end.y, end.z);
  if (!first || !last || !ends) return std::nullopt;
  const int exponent = std::min(first->exponent, last->exponent);
  const auto e0 = in_units(*first, exponent), e1 = in_units(*last, exponent);
  if (!e0 || !e1) return std::nullopt;
  return answer_of(*e0, *e1, start, *ends);
}

PointPlaneToi<double> stages::point_plane_toi::exact(const Plane3d& plane, const Point3d& start, const Point3d& end) {
  auto first = kernel::exact_sum(kernel::height_over(plane, start)),
       last = kernel::exact_sum(kernel::height_over(plane, end));
  const int exponent = std::min(first.exponent, last.exponent);
  first.n <<= static_cast<std::uint64_t>(first.exponent - exponent);
  last.n <<= static_cast<std::uint64_t>(last.exponent - exponent);
  return answer_of(first.n, last.n, start, kernel::integers_of(start.x, start.y, start.z, end.x, end.y, end.z));
}

Decided<PointPlaneToi<double>> stages::point_plane_toi::ask(const Plane3d& plane, const Point3d& start,
                                                            const Point3d& end) {
  return in_turn<point_plane_toi, Stage::filter, Stage::enclosed, validate_point_plane_toi, Stage::lattice,
                 Stage::exact>(plane, start, end);
}

PointPlaneToi<double> point_plane_toi(const Plane3d& plane, const Point3d& start, const Point3d& end) {
  return stages::point_plane_toi::ask(plane, start, end).answer;
}

}  // namespace touchstone::robust
