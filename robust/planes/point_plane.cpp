// SPDX-License-Identifier: Apache-2.0
#include "robust/planes/point_plane.h"

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/filters/lessened.h"
#include "robust/kernel/integers/plane_terms.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

PlaneSide side(int sign) { return sign > 0 ? PlaneSide::front : sign < 0 ? PlaneSide::back : PlaneSide::on; }

void validate_point_plane(const Plane3d& plane, const Point3d& point) {
  if (kernel::valid(plane) && kernel::valid(point)) return;
  validation::validate_all("plane", plane, "point", point);
}

}  // namespace

Perhaps<PlaneSide> stages::point_plane::decision::lattice(const Plane3d& plane, const Point3d& point) {
  const auto height = kernel::lattice_sum(kernel::height_over(plane, point));
  if (!height) return std::nullopt;
  return side(kernel::sign_of(height->n));
}

PlaneSide stages::point_plane::decision::exact(const Plane3d& plane, const Point3d& point) {
  return side(sgn(kernel::exact_sum(kernel::height_over(plane, point)).n));
}

namespace {

/// The filter again, if the guard may have failed: with the normal, the point or both over 2^700. Both are factors of
/// the sum, so the offset is scaled with each.
Perhaps<PlaneSide> filter_of_large(Plane3d plane, Point3d point) {
  Vector3d& n = plane.normal;
  const auto large = [](double x, double y, double z) {
    return !(filters::extent<double, filters::FloatFormat<double>>(x, y, z) <= 0x1p300);
  };
  const bool steep = large(n.x, n.y, n.z), far = large(point.x, point.y, point.z);
  if (!steep && !far) return std::nullopt;
  kernel::Lessened lessened;
  if (steep) n = {lessened(n.x), lessened(n.y), lessened(n.z)}, plane.offset = lessened(plane.offset);
  if (far) point = {lessened(point.x), lessened(point.y), lessened(point.z)}, plane.offset = lessened(plane.offset);
  if (!lessened.exact()) return std::nullopt;
  return stages::point_plane::decision::filter(plane, point);
}

}  // namespace

Decided<PlaneSide> stages::point_plane::decision::past_filter(const Plane3d& plane, const Point3d& point) {
  if (const auto side = filter_of_large(plane, point)) return {*side, Stage::filter};
  return in_turn<decision, validate_point_plane, Stage::lattice, Stage::exact>(plane, point);
}

Perhaps<PointPlane<double>> stages::point_plane::enclosed(const Plane3d& plane, const Point3d& p) {
  using namespace kernel;
  const Vector3d& n = plane.normal;
  const Two x(p.x, n.x), y(p.y, n.y), z(p.z, n.z), offset(plane.offset, 0);
  if (!in_window(x, y, z, offset) || !rounds_to_nearest()) return std::nullopt;
  const Enclosed<Two> height_and_square = enclosed_heights(factors(n), offset, factors(x, y, z));
  const Enclosed<double> height = first(height_and_square), square = second(height_and_square);
  if (!height_and_square.settled() || height.high == 0 || square.high == 0) return std::nullopt;
  const Enclosed<double> length = square_root(square);
  const auto distance = rounded(height / Divisor(length));
  if (!distance) return std::nullopt;
  return {in_place, height.high > 0 ? PlaneSide::front : PlaneSide::back, *distance};
}

namespace {

using kernel::Scaled;

/// height / |N|, by the root of its square.
double distance(const Scaled<mpz_class>& height, const Plane3d& plane) {
  const Scaled<mpz_class> length = kernel::exact_sum(kernel::squared_normal(plane));
  const double size = kernel::round_square_root(height.n * height.n, length.n, 2 * height.exponent - length.exponent);
  return kernel::with_sign(size, sgn(height.n));
}

}  // namespace

Perhaps<PointPlane<double>> stages::point_plane::lattice(const Plane3d& plane, const Point3d& point) {
  const auto height = kernel::lattice_sum(kernel::height_over(plane, point));
  if (!height) return std::nullopt;
  return PointPlane<double>{side(kernel::sign_of(height->n)),
                            distance({kernel::integer_of(height->n), height->exponent}, plane)};
}

PointPlane<double> stages::point_plane::exact(const Plane3d& plane, const Point3d& point) {
  const auto height = kernel::exact_sum(kernel::height_over(plane, point));
  return {side(sgn(height.n)), distance(height, plane)};
}

PointPlane<double> point_plane(const Plane3d& plane, const Point3d& point) {
  return answer_in_turn<stages::point_plane, Stage::enclosed, validate_point_plane, Stage::lattice, Stage::exact>(
      plane, point);
}

}  // namespace touchstone::robust
