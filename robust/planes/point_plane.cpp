// SPDX-License-Identifier: Apache-2.0
#include "robust/planes/point_plane.h"

#include "robust/kernel/cgal_predicates.h"
#include "robust/kernel/valid_space.h"
#include "robust/kernel/plane_terms.h"
#include "robust/kernel/rounding.h"

namespace touchstone::robust {
namespace {

using kernel::Scaled;

PlaneSide side(int sign) { return sign > 0 ? PlaneSide::front : sign < 0 ? PlaneSide::back : PlaneSide::on; }

/// height / |N|, by the root of its square.
double distance(const Scaled<mpz_class>& height, const Plane3d& plane) {
  const Scaled<mpz_class> length = kernel::exact_sum(kernel::squared_normal(plane));
  const double size = kernel::round_square_root(height.n * height.n, length.n, 2L * height.exponent - length.exponent);
  return kernel::with_sign(size, sgn(height.n));
}

void validate(const Plane3d& plane, const Point3d& point) {
  if (kernel::valid(plane) && kernel::valid(point)) return;
  validation::validate("plane", plane), validation::validate("point", point);
}

}  // namespace

std::optional<PlaneSide> point_plane_side_lattice(const Plane3d& plane, const Point3d& point) {
  const auto height = kernel::lattice_sum(kernel::height_over(plane, point));
  if (!height) return std::nullopt;
  return side(kernel::sign_of(height->n));
}

PlaneSide point_plane_side_exact(const Plane3d& plane, const Point3d& point) {
  return side(kernel::sign_by_cgal(kernel::exact_sum(kernel::height_over(plane, point)).n));
}

PlaneSide point_plane_side_past_filter(const Plane3d& plane, const Point3d& point, Stage& decided) {
  validate(plane, point);
  decided = Stage::lattice;
  if (const auto answer = point_plane_side_lattice(plane, point)) return *answer;
  decided = Stage::exact;
  return point_plane_side_exact(plane, point);
}

std::optional<PointPlane<double>> point_plane_lattice(const Plane3d& plane, const Point3d& point) {
  const auto height = kernel::lattice_sum(kernel::height_over(plane, point));
  if (!height) return std::nullopt;
  return PointPlane<double>{side(kernel::sign_of(height->n)),
                            distance({kernel::integer_of(height->n), height->exponent}, plane)};
}

PointPlane<double> point_plane_exact(const Plane3d& plane, const Point3d& point) {
  const auto height = kernel::exact_sum(kernel::height_over(plane, point));
  return {side(kernel::sign_by_cgal(height.n)), distance(height, plane)};
}

PointPlane<double> point_plane(const Plane3d& plane, const Point3d& point) {
  validate(plane, point);
  if (const auto answer = point_plane_lattice(plane, point)) return *answer;
  return point_plane_exact(plane, point);
}

}  // namespace touchstone::robust
