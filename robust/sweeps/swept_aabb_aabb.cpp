// SPDX-License-Identifier: Apache-2.0
#include "robust/sweeps/swept_aabb_aabb.h"

#include <tuple>

#include "robust/kernel/enclosed/window.h"
#include "robust/kernel/filters/box_differences.h"
#include "robust/kernel/integers/axis_times.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using kernel::AxisMotion;
using kernel::greater;
using kernel::lesser;

std::array<AxisMotion<double>, 2> axes_of(const Aabb2d& a, const Aabb2d& b, const Vector2d& v) {
  return {{{a.min.x, a.max.x, b.min.x, b.max.x, v.x}, {a.min.y, a.max.y, b.min.y, b.max.y, v.y}}};
}
std::array<AxisMotion<double>, 3> axes_of(const Aabb3d& a, const Aabb3d& b, const Vector3d& v) {
  return {{{a.min.x, a.max.x, b.min.x, b.max.x, v.x},
           {a.min.y, a.max.y, b.min.y, b.max.y, v.y},
           {a.min.z, a.max.z, b.min.z, b.max.z, v.z}}};
}

/// Conclusions from quotients of doubles about a step. Each time is a difference divided by a velocity.
///
/// Guard: every difference, as computed, is at least 2^-900 in size. Then reading subnormals as zero costs it at most
/// 2^-1021, which is 2^-121 of it: with u = 2^-52, which bounds a rounding in every mode, it is off by u + 2^-120, and
/// has the right sign. (One that overflows is beyond every velocity: its time is at least 1 or at most -1, as it is and
/// as computed, and no more counts of it.) Its quotient is off by u more, where that underflows by 2^-1021. A velocity
/// that is subnormal may be read as zero, but then the time is beyond 2^100 as it is, and the quotient infinite with
/// the same sign. A velocity of 0 makes infinities too: an entry of -infinity and an exit of infinity where the
/// intervals overlap, otherwise both of one sign, as if a were there at no time of the step. So a time T, cut to [-1,
/// 2], is off by less than 2.5 u |T| + 2^-1020, and so are the latest entry and the earliest exit.
///
/// Both entries and exits are compared with the sign of entry - exit, rounded with u of it: where that is beyond 4 u
/// (entry + |exit|) + 2^-1000, of which three roundings leave more than 3.7 u, it is certain. Not proved by machine.
class Times {
 public:
  void cut(const AxisMotion<double>& m) {
    const double to_near = m.b_min - m.a_max, to_far = m.b_max - m.a_min;
    const double size = __builtin_fabs(to_near), other = __builtin_fabs(to_far);
    least_ = lesser(least_, lesser(size, other));
    const double one = to_near / m.velocity, two = to_far / m.velocity;
    entry_ = greater(entry_, lesser(one, two)), exit_ = lesser(exit_, greater(one, two));
  }

  bool guarded() const { return least_ >= 0x1p-900; }
  bool never() const { return order() - error() > 0; }
  bool meets() const { return order() + error() < 0; }
  /// All entries are before the start.
  bool starts_within() const { return entry_ < 0; }
  /// Returns whether an entry may be the latest, judging by its computed time.
  bool may_be_latest(double time) const { return time >= entry_ - (8 * u * entry_ + 0x1p-1000); }

 private:
  static constexpr double u = 0x1p-52;
  double first() const { return lesser(greater(entry_, 0), 2); }
  double last() const { return greater(lesser(exit_, 1), -1); }
  double order() const { return first() - last(); }
  double error() const { return 4 * u * (first() + __builtin_fabs(last())) + 0x1p-1000; }

  double least_ = 0x1p1000, entry_ = -2, exit_ = 2;
};

}  // namespace

template <class Box, class Vector>
Perhaps<FirstContact<double>> stages::swept_aabb_aabb::filter(const Box& a, const Box& b, const Vector& velocity) {
  Times times;
  for (const auto& axis : axes_of(a, b, velocity)) times.cut(axis);
  if (!times.guarded()) return std::nullopt;
  if (times.never()) return FirstContact<double>{HitRelation::never, std::nullopt};
  if (times.meets() && times.starts_within()) return FirstContact<double>{HitRelation::hit, 0.0};
  return std::nullopt;
}

/// The latest entry of a step that the filter has decided as a hit after the start. Rounding is monotone: the greatest
/// of the times, rounded, is the greatest of the rounded times.
template <class Box, class Vector>
Perhaps<FirstContact<double>> stages::swept_aabb_aabb::enclosed(const Box& a, const Box& b, const Vector& velocity) {
  using namespace kernel;
  const auto axes = axes_of(a, b, velocity);
  Times times;
  for (const auto& axis : axes) times.cut(axis);
  if (!times.guarded() || !times.meets() || !rounds_to_nearest()) return std::nullopt;
  double latest = 0;
  for (const auto& m : axes) {
    if (m.velocity == 0) continue;  // or subnormal, and its entry long past
    const bool forwards = m.velocity > 0;
    const double to = forwards ? m.b_min : m.b_max, from = forwards ? m.a_max : m.a_min;
    if (!times.may_be_latest((to - from) / m.velocity)) continue;
    if (!in_window(Two(to, from), Two(m.velocity))) return std::nullopt;
    const Pair<double> displacement = difference(to, from);
    const auto t =
        rounded(Enclosed<double>{displacement.high, displacement.low, 0} / Divisor(Enclosed<double>{m.velocity, 0, 0}));
    if (!t) return std::nullopt;
    latest = greater(latest, *t);
  }
  if (!(latest > 0)) return std::nullopt;
  return FirstContact<double>{HitRelation::hit, latest};
}

namespace {

template <class Numbers>
FirstContact<double> contact_of(const Numbers& n) {
  kernel::AxisTimes<std::decay_t<decltype(n[0])>> times;
  for (std::size_t i = 0; i < n.size(); i += 5) times.cut({n[i], n[i + 1], n[i + 2], n[i + 3], n[i + 4]});
  return times.contact();
}

/// call(all numbers, axis by axis)
template <class Call>
auto of_numbers(const Call& call, const AxisMotion<double>& x, const AxisMotion<double>& y) {
  return call(x.a_min, x.a_max, x.b_min, x.b_max, x.velocity, y.a_min, y.a_max, y.b_min, y.b_max, y.velocity);
}
template <class Call>
auto of_numbers(const Call& call, const AxisMotion<double>& x, const AxisMotion<double>& y,
                const AxisMotion<double>& z) {
  return call(x.a_min, x.a_max, x.b_min, x.b_max, x.velocity, y.a_min, y.a_max, y.b_min, y.b_max, y.velocity, z.a_min,
              z.a_max, z.b_min, z.b_max, z.velocity);
}

bool valid(const Vector2d& v) { return kernel::all_finite(v.x, v.y); }
bool valid(const Vector3d& v) { return kernel::valid(v); }

template <class Box, class Vector>
void validate_swept_aabb_aabb(const Box& a, const Box& b, const Vector& velocity) {
  if (kernel::valid(a) && kernel::valid(b) && valid(velocity)) return;
  validation::validate_all("a", a, "b", b, "velocity", velocity);
}

}  // namespace

template <class Box, class Vector>
Perhaps<FirstContact<double>> stages::swept_aabb_aabb::lattice(const Box& a, const Box& b, const Vector& velocity) {
  const auto lattice = std::apply(
      [](const auto&... axis) { return of_numbers([](auto... n) { return kernel::lattice_of(n...); }, axis...); },
      axes_of(a, b, velocity));
  if (!lattice) return std::nullopt;
  return contact_of(lattice->at);
}

template <class Box, class Vector>
FirstContact<double> stages::swept_aabb_aabb::exact(const Box& a, const Box& b, const Vector& velocity) {
  return std::apply(
      [](const auto&... axis) {
        return of_numbers([](auto... n) { return contact_of(kernel::integers_of(n...).at); }, axis...);
      },
      axes_of(a, b, velocity));
}

/// The filter does not check which end of an interval is the lesser: boxes are validated first.
template <class Box, class Vector>
Decided<FirstContact<double>> stages::swept_aabb_aabb::ask(const Box& a, const Box& b, const Vector& velocity) {
  return in_turn<swept_aabb_aabb, validate_swept_aabb_aabb<Box, Vector>, Stage::filter, Stage::enclosed, Stage::lattice,
                 Stage::exact>(a, b, velocity);
}

FirstContact<double> swept_aabb_aabb(const Aabb2d& a, const Aabb2d& b, const Vector2d& velocity) {
  return stages::swept_aabb_aabb::ask(a, b, velocity).answer;
}
FirstContact<double> swept_aabb_aabb(const Aabb3d& a, const Aabb3d& b, const Vector3d& velocity) {
  return stages::swept_aabb_aabb::ask(a, b, velocity).answer;
}

template Perhaps<FirstContact<double>> stages::swept_aabb_aabb::filter(const Aabb2d&, const Aabb2d&, const Vector2d&);
template Perhaps<FirstContact<double>> stages::swept_aabb_aabb::filter(const Aabb3d&, const Aabb3d&, const Vector3d&);
template Perhaps<FirstContact<double>> stages::swept_aabb_aabb::enclosed(const Aabb2d&, const Aabb2d&, const Vector2d&);
template Perhaps<FirstContact<double>> stages::swept_aabb_aabb::enclosed(const Aabb3d&, const Aabb3d&, const Vector3d&);
template Perhaps<FirstContact<double>> stages::swept_aabb_aabb::lattice(const Aabb2d&, const Aabb2d&, const Vector2d&);
template Perhaps<FirstContact<double>> stages::swept_aabb_aabb::lattice(const Aabb3d&, const Aabb3d&, const Vector3d&);
template FirstContact<double> stages::swept_aabb_aabb::exact(const Aabb2d&, const Aabb2d&, const Vector2d&);
template FirstContact<double> stages::swept_aabb_aabb::exact(const Aabb3d&, const Aabb3d&, const Vector3d&);
template Decided<FirstContact<double>> stages::swept_aabb_aabb::ask(const Aabb2d&, const Aabb2d&, const Vector2d&);
template Decided<FirstContact<double>> stages::swept_aabb_aabb::ask(const Aabb3d&, const Aabb3d&, const Vector3d&);

}  // namespace touchstone::robust
