// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "robust/kernel/filters/obb_filter.h"

/// The first stage for velocities at a contact: the model and the rules (1), (4) to (6) of filters.h, the guard H and
/// the absolute term of face_filter.h.
namespace touchstone::robust::filters {

/// The sign of n . (va + wa x (p - a) - vb - wb x (p - b)). Unknown if the normal may be zero.
///
/// With |x| for the sum of the magnitudes of a vector's coordinates, let P = |n| (|va| + |vb| + |wa| |p - a| + |wb|
/// |p - b|), taken exactly: at least the sum of the magnitudes of all products. A product goes through a difference (in
/// p - a), a product, the differences in w x (p - a) and of both velocities, a sum, a product with n and at most two
/// sums: eight roundings, the last of which is shared and cannot make a sign wrong by (4). So a value of the wrong sign
/// is at most (1 + u) ((1 + u)^7 - 1) P (FMA only leaves roundings out). P is computed as at least (1 - u)^11 P: |n|
/// and |w| lose two roundings each, |p - a| three, their product one, three sums and products one each. The bound has
/// two more: C (1 - u)^13 >= (1 + u) ((1 + u)^7 - 1) = 7 u + .... C = 7 u + 224 u^2: at u = 1/16, 2.971 < 3 in units of
/// 7 u. (Looser by much: P holds nine products of n and v and 27 of n, w and p - a, where there are three and six.)
///
/// Guard: a sum of sizes that contains |n| and all in P's parentheses is at most H, as computed: every number is at
/// most H in magnitude, and P as computed at most H^3.
///
/// Absolute terms, for u <= 1/16 and H >= 2, in units of n H^2. p - a is off by 4 n and w is read as zero for n, so a
/// product of both by less than 7 n H, flushed; a coordinate of the cross product by 17 n H, of a velocity by 20 n H,
/// of their difference by 43 n H, and with all roundings by less than 60 n H. It is at most 1.5 H^2. The scalar product
/// with n: 60 for that; 1.5, 1 and 1 for each of three products, whose factors may be read as zero; 6 for the sums, all
/// times (1 + u)^3: less than 94. The bound: |n| is off by 11 n, |w| by 11 n, |p - a| by 16 n, |va| + |vb| by 24 n, so
/// P by less than 17 + 2 (11 + 16) + 24 + 5 = 100, times C <= 1.4; and 4 for itself. Less than 240 together, and 512
/// times 1 - u pays for it. Proved.
template <class Float, class Format = FloatFormat<Float>>
Sign velocity_apart(const MovingBody<Float>& a, const MovingBody<Float>& b, const Point3<Float>& p,
                    const Vector3<Float>& n) {
  using B = CubicBounds<Float, Format>;
  const Vector3<Float> from_a = p - a.position, from_b = p - b.position;
  const Vector3<Float> of_a = a.velocity + cross(a.angular_velocity, from_a),
                       of_b = b.velocity + cross(b.angular_velocity, from_b);
  const Float value = dot(n, of_a - of_b);
  const auto size = [](const Vector3<Float>& v) { return size_of<Float, Format>(v); };
  const Float size_n = size(n), straight = size(a.velocity) + size(b.velocity), turn_a = size(a.angular_velocity),
              turn_b = size(b.angular_velocity), arm_a = size(from_a), arm_b = size(from_b);
  const Float terms = size_n * (straight + (turn_a * arm_a + turn_b * arm_b));
  const Float error = Bounds<Float, Format>::template relative<14, 224>() * terms + B::absolute();
  const Float sum = (size_n + straight) + ((turn_a + arm_a) + (turn_b + arm_b));
  return certain<Float, Format>(value, error, sum, B::high());
}

}  // namespace touchstone::robust::filters
