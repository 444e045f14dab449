// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/filters.h"

/// The first stage for a moving ball and a plane: the model of filters.h, the constants of binary64.
namespace touchstone::robust::filters {

/// The time at which a ball first meets a plane, as far as signs decide it.
enum class Meeting { unknown, at_start, later, never };

/// Conclusions from a few operations on doubles, with u = 2^-52, which bounds a rounding in every mode.
///
/// E0 is the height of the center at the start, S what it gains, and R = r sqrt(N . N). Let n, p, v be the sums of the
/// magnitudes of the coordinates of N, of the center and of the velocity. E0 is off by less than 4 u (n p + |d|) (1 + 2
/// u), S by 3 u n v (1 + 2 u). N . N is off by 3 u of itself, so that R is off by 1.5 u, by u for the root and u for
/// the product: less than 4 u R. The start is decided by |E0| and R, whose difference cannot round to a wrong sign: 5 u
/// (n p + |d| + R) leaves a fifth for the bound's own roundings. The end is decided by that difference, rounded with u
/// (n p + |d| + R), and S, added or taken off: of 7 u (n (p + v) + |d| + R) two sevenths are left.
///
/// Guards: N . N in [2^-900, 2^900], so that what underflows in it is below 2^-100 u of it; n, p, v and r together at
/// most 2^500. Then reading a subnormal as zero costs a term less than 2^-1022 2^500, and everything together less than
/// 2^-510. The offset needs no guard: where the bound overflows, nothing is greater; where E0 alone does, an infinity
/// has its sign. NaN fails each comparison. Proved: heights_meeting.
template <class Float, class Format = FloatFormat<Float>>
class Heights {
  using B = Bounds<Float, Format>;
  static_assert(Format::precision == 53 && Format::min_exponent == -1022, "the guards are those of binary64");

 public:
  Heights(const Sphere3<Float>& sphere, const Vector3<Float>& velocity, const Plane<Float>& plane) {
    const Vector3<Float>& n = plane.normal;
    const Point3<Float>& c = sphere.center;
    squares_ = n.x * n.x + n.y * n.y + n.z * n.z;
    height_ = n.x * c.x + n.y * c.y + n.z * c.z + plane.offset;
    rise_ = n.x * velocity.x + n.y * velocity.y + n.z * velocity.z;
    reach_ = sphere.radius * Format::square_root(squares_);
    const Float of_normal = extent<Float, Format>(n.x, n.y, n.z), of_center = extent<Float, Format>(c.x, c.y, c.z),
                of_velocity = extent<Float, Format>(velocity.x, velocity.y, velocity.z);
    at_start_ = of_normal * of_center + Format::magnitude(plane.offset) + reach_;
    at_end_ = at_start_ + of_normal * of_velocity;
    size_ = of_normal + of_center + of_velocity + sphere.radius;
  }

  Meeting meeting() const {
    const bool guarded = squares_ >= Format::above(power_of_two(-900)) &&
                         squares_ <= Format::above(power_of_two(900)) && size_ <= Format::above(power_of_two(500));
    if (!guarded) return Meeting::unknown;
    const Float gap = Format::magnitude(height_) - reach_, error = Format::above(5 * B::u) * at_start_ + least();
    if (gap < -error) return Meeting::at_start;
    if (!(gap > error)) return Meeting::unknown;
    const Float last = gap + (behind() ? -rise_ : rise_), error_at_end = Format::above(7 * B::u) * at_end_ + least();
    if (last > error_at_end) return Meeting::never;
    return last < -error_at_end ? Meeting::later : Meeting::unknown;
  }

  /// True if the meeting is certain and not at the start.
  bool behind() const { return height_ < Float(); }

 private:
  static Float least() { return Format::above(power_of_two(-500)); }

  Float squares_, height_, rise_, reach_, at_start_, at_end_, size_;
};

}  // namespace touchstone::robust::filters
