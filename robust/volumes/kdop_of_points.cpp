// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/kdop_of_points.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "robust/kernel/filters/extreme_filter.h"
#include "robust/kernel/integers/outward.h"
#include "robust/kernel/integers/term_sum.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<kernel::Term, 3> height(const Vector3d& n, const Point3d& p) {
  return {kernel::term(n.x, p.x), kernel::term(n.y, p.y), kernel::term(n.z, p.z)};
}

/// The greatest sum of magnitudes of a point's coordinates.
double greatest_extent(const std::vector<Point3d>& points) {
  double greatest = 0;
  for (const Point3d& p : points) greatest = filters::greater_extent(p, greatest);
  return greatest;
}

/// Calls visit(point) for every point that may have the least or the greatest N . P.
template <class Visit>
bool for_each_candidate(const std::vector<Point3d>& points, const Vector3d& n, double of_points, const Visit& visit) {
  double low = infinity, high = -infinity;
  for (const Point3d& p : points) {
    const double value = filters::height(n, p);
    low = filters::lower(value, low), high = filters::higher(value, high);
  }
  const double apart = filters::doubt(n, of_points);
  for (const Point3d& p : points) {
    if (filters::between(filters::height(n, p), low, high, apart)) continue;
    if (!visit(p)) return false;
  }
  return true;
}

/// The interval around all added numbers: rounding is monotone, so the ends may be rounded one by one.
class Outward {
 public:
  template <class Integer>
  void add(const kernel::Scaled<Integer>& number) {
    const double below = kernel::round_down(number.n, number.exponent),
                 above = kernel::round_up(number.n, number.exponent);
    if (empty_ || !validation::in_order(slab_.min, below)) slab_.min = below;
    if (empty_ || !validation::in_order(above, slab_.max)) slab_.max = above;
    empty_ = false;
  }
  const Slabd& slab() const { return slab_; }

 private:
  Slabd slab_{};
  bool empty_ = true;
};

void validate_kdop_of_points(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals) {
  validation::validate_numbers("points", points), validation::validate_numbers("normals", normals);
  if (points.empty()) validation::validate("points", points, rule::points);
  if (normals.empty()) validation::validate("normals", normals, rule::normals);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!kernel::valid(normals[i], rule::normal))
      validation::validate("normals[" + std::to_string(i) + "]", normals[i], rule::normal);
  }
}

}  // namespace

Perhaps<std::vector<Slabd>> stages::kdop_of_points::lattice(const std::vector<Point3d>& points,
                                                            const std::vector<Vector3d>& normals) {
  std::vector<Slabd> slabs;
  slabs.reserve(normals.size());
  const double of_points = greatest_extent(points);
  for (const Vector3d& n : normals) {
    Outward around;
    const bool known = for_each_candidate(points, n, of_points, [&](const Point3d& p) {
      const auto sum = kernel::lattice_sum(height(n, p));
      if (sum) around.add(*sum);
      return sum.has_value();
    });
    if (!known) return std::nullopt;
    slabs.push_back(around.slab());
  }
  return slabs;
}

std::vector<Slabd> stages::kdop_of_points::exact(const std::vector<Point3d>& points,
                                                 const std::vector<Vector3d>& normals) {
  std::vector<Slabd> slabs;
  for (const Vector3d& n : normals) {
    Outward around;
    for (const Point3d& p : points) around.add(kernel::exact_sum(height(n, p)));
    slabs.push_back(around.slab());
  }
  return slabs;
}

Decided<std::vector<Slabd>> stages::kdop_of_points::ask(const std::vector<Point3d>& points,
                                                        const std::vector<Vector3d>& normals) {
  validate_kdop_of_points(points, normals);
  return in_turn<kdop_of_points, Stage::lattice, Stage::exact>(points, normals);
}

std::vector<Slabd> kdop_of_points(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals) {
  return stages::kdop_of_points::ask(points, normals).answer;
}

}  // namespace touchstone::robust
