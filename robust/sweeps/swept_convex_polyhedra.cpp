// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_convex_polyhedra.h"

#include <algorithm>
#include <limits>

#include "geometry/validation.h"
#include "robust/kernel/integers/axis_times.h"
#include "robust/kernel/shapes/points_in_space.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust {
namespace {

/// (q - p) x (s - r), by their indices in the list of all vertices: those of a, then those of b.
struct Axis {
  Index p, q, r, s;
};

/// The normals of all faces, and the cross products of an edge of a and one of b: enough, as the contract proves.
std::vector<Axis> axes_of(const Meshd& a, const Meshd& b) {
  const auto shift = static_cast<Index>(a.vertices.size());
  std::vector<Axis> axes;
  std::vector<std::pair<Index, Index>> edges_of_a, edges_of_b;
  const auto note = [&axes](const Meshd& mesh, Index first, auto& edges) {
    for (const Face& f : mesh.faces) {
      const Index i = f.a + first, j = f.b + first, k = f.c + first;
      axes.push_back({i, j, i, k});
      // Takes each edge once: its reverse is in another face.
      for (const auto& [from, to] : {std::pair{i, j}, std::pair{j, k}, std::pair{k, i}})
        if (from < to) edges.push_back({from, to});
    }
  };
  note(a, 0, edges_of_a), note(b, shift, edges_of_b);
  for (const auto& [p, q] : edges_of_a)
    for (const auto& [r, s] : edges_of_b) axes.push_back({p, q, r, s});
  return axes;
}

/// Bounds on the times at which a enters and leaves b on one axis. The default: no bounds.
struct TimeBounds {
  static constexpr double endless = std::numeric_limits<double>::infinity();
  double entry_low = -endless, entry_high = endless, exit_low = -endless, exit_high = endless;
};

/// Bounds on times from doubles, with u = 2^-52, which bounds a rounding in every mode.
///
/// All points are taken from the first, P. D is the greatest coordinate of these and of the velocity; k and m are those
/// of the axis' two edges; units are u D k m. An edge's coordinate is off by u of itself, so one of the axis, two
/// products and a difference, is at most 2 k m and off by 8 u k m. A point's coordinates are off by u D: three products
/// with the axis, of at most 6 D k m together, are off by 6 units for that, 24 for the axis, and 18 for their own
/// roundings and those of two sums: by 48. (Terms of u^2 are far below one unit, and so is P times the axis, which all
/// values share and which cancels in differences.) A difference of two is off by 96, and rounded from at most 12 D k m
/// by 12 more; the velocity by 42. Adding to them or subtracting below rounds by as much again: 120 and 54.
/// An error of 128 units, 2^-45 D k m, pays for all.
///
/// Guards: D is at most 2^250, and k and m at least 2^-250. Then nothing overflows, and what underflows, or is read as
/// zero, costs less than 2^-1022 (1 + D + k m D), which is below 2^-400 units. Not proved by machine.
class Projections {
 public:
  Projections(const std::vector<Point3d>& points, std::size_t count_of_a, const Vector3d& velocity)
      : points_(points), count_of_a_(count_of_a), velocity_(velocity), greatest_(size(velocity)) {
    from_first_.reserve(points.size());
    for (const Point3d& p : points) {
      from_first_.push_back(p - points[0]);
      greatest_ = std::max(greatest_, size(from_first_.back()));
    }
  }

  TimeBounds times(const Axis& axis) const {
    const Vector3d v = points_[axis.q] - points_[axis.p], w = points_[axis.s] - points_[axis.r];
    const double k = size(v), m = size(w);
    if (!(greatest_ <= 0x1p250 && k >= 0x1p-250 && m >= 0x1p-250)) return {};
    const Vector3d n = cross(v, w);
    const double error = 0x1p-45 * greatest_ * k * m;
    const auto [a_min, a_max] = interval(n, 0, count_of_a_);
    const auto [b_min, b_max] = interval(n, count_of_a_, points_.size());
    const double speed = dot(n, velocity_);
    return speed < 0 ? bounds(a_min - b_max, a_max - b_min, -speed, error)
                     : bounds(b_min - a_max, b_max - a_min, speed, error);
  }

 private:
  static double size(const Vector3d& v) {
    return std::max({__builtin_fabs(v.x), __builtin_fabs(v.y), __builtin_fabs(v.z)});
  }

  std::pair<double, double> interval(const Vector3d& n, std::size_t begin, std::size_t end) const {
    double min = dot(n, from_first_[begin]), max = min;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const double value = dot(n, from_first_[i]);
      min = value < min ? value : min, max = value > max ? value : max;
    }
    return {min, max};
  }

  /// A quotient is off by u, and is moved by four. A speed within its error of 0 is at most twice that, so that during
  /// the step nothing moves by more than twice the error: if the intervals overlap, or are apart, by four, they do so
  /// all the time.
  static TimeBounds bounds(double near, double far, double speed, double error) {
    const double slow = speed - error, fast = speed + error;
    if (!(slow > 0)) {
      constexpr double endless = TimeBounds::endless;
      if (near + 4 * error < 0 && far - 4 * error > 0) return {-endless, -endless, endless, endless};
      if (near - 4 * error > 0 || far + 4 * error < 0) return {endless, endless, -endless, -endless};
      return {};
    }
    const auto low = [=](double displacement) {
      return moved(displacement - error > 0 ? (displacement - error) / fast : (displacement - error) / slow, -1);
    };
    const auto high = [=](double displacement) {
      return moved(displacement + error > 0 ? (displacement + error) / slow : (displacement + error) / fast, 1);
    };
    return {low(near), high(near), low(far), high(far)};
  }
  static double moved(double quotient, double side) { return quotient + side * (0x1p-50 * __builtin_fabs(quotient)); }

  const std::vector<Point3d>& points_;
  std::size_t count_of_a_;
  const Vector3d& velocity_;
  std::vector<Vector3d> from_first_;
  double greatest_;
};

/// The same, exactly, for single axes.
class IntegerProjections {
 public:
  IntegerProjections(const std::vector<Point3d>& points, std::size_t count_of_a, const Vector3d& velocity)
      : count_of_a_(count_of_a) {
    Polygon3d all{points};
    all.vertices.push_back({velocity.x, velocity.y, velocity.z});
    points_ = kernel::integers_of(all).at;
    velocity_ = {points_.back().x, points_.back().y, points_.back().z};
    points_.pop_back();
  }

  void cut(const Axis& axis) {
    const Vector3<mpz_class> n = cross(points_[axis.q] - points_[axis.p], points_[axis.s] - points_[axis.r]);
    if (sgn(n.x) == 0 && sgn(n.y) == 0 && sgn(n.z) == 0) return;
    const auto [a_min, a_max] = interval(n, 0, count_of_a_);
    const auto [b_min, b_max] = interval(n, count_of_a_, points_.size());
    times_.cut({a_min, a_max, b_min, b_max, dot(n, velocity_)});
  }

  FirstContact<double> contact() const { return times_.contact(); }

 private:
  std::pair<mpz_class, mpz_class> interval(const Vector3<mpz_class>& n, std::size_t begin, std::size_t end) const {
    const auto at = [&n](const Point3<mpz_class>& p) { return dot(n, Vector3<mpz_class>{p.x, p.y, p.z}); };
    mpz_class min = at(points_[begin]), max = min;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const mpz_class value = at(points_[i]);
      if (value < min) min = value;
      if (value > max) max = value;
    }
    return {min, max};
  }

  std::size_t count_of_a_;
  std::vector<Point3<mpz_class>> points_;
  Vector3<mpz_class> velocity_;
  kernel::AxisTimes<mpz_class> times_;
};

/// True if the edges are parallel: then the axis is zero, and decides nothing. Called if an axis may be zero.
bool parallel(const std::vector<Point3d>& points, const Axis& axis) {
  const Point3d &p = points[axis.p], &q = points[axis.q], &r = points[axis.r], &s = points[axis.s];
  const auto lattice = kernel::lattice_of(p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y, r.z, s.x, s.y, s.z);
  if (!lattice) return false;  // left to the exact stage
  const auto& n = lattice->at;
  const auto equal = [&n](std::size_t i, std::size_t j) {
    return static_cast<kernel::Int128>(n[3 + i] - n[i]) * (n[9 + j] - n[6 + j]) ==
           static_cast<kernel::Int128>(n[3 + j] - n[j]) * (n[9 + i] - n[6 + i]);
  };
  return equal(0, 1) && equal(1, 2) && equal(2, 0);
}

/// The latest entry lies between the greatest lower and the greatest upper bound of all, the earliest exit likewise.
/// Only axes that reach these need exact times.
Decided<FirstContact<double>> first_contact(const Meshd& a, const Meshd& b, const Vector3d& velocity) {
  std::vector<Point3d> points = a.vertices;
  points.insert(points.end(), b.vertices.begin(), b.vertices.end());
  const Projections projections(points, a.vertices.size(), velocity);
  std::vector<Axis> axes = axes_of(a, b);
  std::vector<TimeBounds> known;
  known.reserve(axes.size());
  TimeBounds all{0, 0, 1, 1};
  for (const Axis& axis : axes) {
    TimeBounds times = projections.times(axis);
    if (times.entry_high > 1 && times.entry_low < 0 && parallel(points, axis)) times = {-1, -1, 2, 2};
    all = {std::max(all.entry_low, times.entry_low), std::max(all.entry_high, times.entry_high),
           std::min(all.exit_low, times.exit_low), std::min(all.exit_high, times.exit_high)};
    known.push_back(times);
  }
  if (all.entry_low > all.exit_high) return {{HitRelation::never, std::nullopt}, Stage::filter};
  const bool hits = all.entry_high <= all.exit_low;
  if (hits && all.entry_high <= 0) return {{HitRelation::hit, 0.0}, Stage::filter};
  IntegerProjections in_integers(points, a.vertices.size(), velocity);
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (known[i].entry_high >= all.entry_low || (!hits && known[i].exit_low <= all.exit_high)) in_integers.cut(axes[i]);
  return {in_integers.contact(), Stage::exact};
}

}  // namespace

Decided<FirstContact<double>> stages::swept_convex_polyhedra::ask(const Meshd& a, const Meshd& b,
                                                                  const Vector3d& velocity) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b),
      validation::validate_numbers("velocity", velocity);
  Stage latest = Stage::filter;
  kernel::validate_convex("a", a, latest), kernel::validate_convex("b", b, latest);
  Decided<FirstContact<double>> found = first_contact(a, b, velocity);
  return {found.noting(latest), latest};
}

FirstContact<double> swept_convex_polyhedra(const ConvexSolid& a, const ConvexSolid& b, const Vector3d& velocity) {
  validation::validate("velocity", velocity);
  return first_contact(a.mesh(), b.mesh(), velocity).answer;
}

FirstContact<double> swept_convex_polyhedra(const Meshd& a, const Meshd& b, const Vector3d& velocity) {
  return stages::swept_convex_polyhedra::ask(a, b, velocity).answer;
}

}  // namespace touchstone::robust
