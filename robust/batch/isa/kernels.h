// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/filters.h"
#include "robust/batch/isa/lanes.h"

/// Shared by the filters of arrays, and the proof that they are right.
///
/// Model. These filters run only where results are rounded to nearest and nothing is flushed, so the universal model of
/// robust/kernel/filters/filters.h is not needed: with v = 2^-53, the result of a sum or a difference is exact * (1 +
/// e), and that of a product exact * (1 + e) + h, with |e| <= v and |h| <= 2^-1075; a sum that underflows is exact. An
/// FMA leaves a rounding out. The total cost of underflow is a sum of a few h, each at most times a small constant:
/// every bound here ends with + 2^-1000, which pays for it many times over, and for what the bound itself loses by
/// underflow.
///
/// Overflow. |value| > bound is false if the bound is infinite or NaN. So each bound is constructed to be infinite or
/// NaN whenever anything in the value is, and no other guard is needed. A bound of the form C * size with a small C
/// would stay finite when a partial sum of the value overflows. Each filter says how it avoids that. The same holds for
/// infinite and NaN inputs: the row is not decided here, and a later stage refuses it.
///
/// With m <= 12 roundings before a bound it is at least (1 - v)^m of the exact one. Each C is a power of two
/// that exceeds what is needed by a seventh at least, which pays for that and for all terms of higher order in v. The
/// filters of this file are proved by machine from this text (robust/proofs/lane_*.v); triangles.h and beside.h say
/// which of theirs are proved.
namespace touchstone::robust::batch::isa {
namespace {

/// The rows that a filter decides, and among these the rows whose answer is F::set and not F::clear.
struct Verdict {
  Mask known, set;
};

constexpr double v = 0x1p-53, tiny = 0x1p-1000;

/// |value| > bound, with the sign of the value.
Verdict by_sign(Lanes value, Lanes bound) { return {above(magnitude(value), bound), negative(value)}; }

/// The turn of three points in the plane.
///
/// Let l and r be the exact products, L and R the computed ones: L lies between l (1 - v)^3 and l (1 + v)^3, R
/// likewise. If the signs of l and r differ or one is 0, L - R has the right sign, or is 0. Otherwise let both be
/// positive, and L > R though l <= r: R >= q L with q = ((1 - v) / (1 + v))^3, so L - R <= (1 - q) / (1 + q) (L + R),
/// and that is tanh(3 artanh v) <= 3 v. C = 4 v; there are points that need 2.9999999 v
/// (proptests/agreement/arrays.cpp).
///
/// The sum L + R is itself the size: where L and R are so large that it overflows, the bound is infinite. Where L - R
/// overflows and L + R does not, the signs differ, and that of L - R is right. An infinite L or R makes both infinite,
/// or one of them NaN. Every coordinate is in a difference, and an infinite or NaN difference makes L or R infinite or
/// NaN.
struct Turn {
  Lanes value, bound;
  Turn(Lanes px, Lanes py, Lanes qx, Lanes qy, Lanes x, Lanes y) {
    const Lanes l = (qx - px) * (y - py), r = (qy - py) * (x - px);
    value = l - r;
    bound = multiply_add(magnitude(l + r), same(4 * v), same(tiny));
  }
};

struct Orientation {
  static constexpr std::size_t columns = 6;
  static constexpr std::uint8_t set = 2, clear = 0;  // right, left
  static Verdict of(const Lanes* c) {
    const Turn turn(c[0], c[1], c[2], c[3], c[4], c[5]);
    return by_sign(turn.value, turn.bound);
  }
};

/// Decides only points that are certainly off the line of the segment.
struct PointOnSegment {
  static constexpr std::size_t columns = 6;
  static constexpr std::uint8_t set = 1, clear = 1;  // off
  static Verdict of(const Lanes* c) {
    const Turn turn(c[2], c[3], c[4], c[5], c[0], c[1]);
    return {above(magnitude(turn.value), turn.bound), 0};
  }
};

/// The value is that of filters::segments, whose meaning is proved there: if negative, the segments cross; if positive,
/// the line of one has the other on one side. Seven roundings precede the last difference, of products that add up to 2
/// ex ey at most: 14 v and terms of higher order. C = 2^4 v.
///
/// With Q = ex ey as computed, every product is at most Q, rs, rf and sf are at most 2 Q, and each sum of them at most
/// 8 Q. The bound is infinite if 2^8 Q is, so nothing in the value overflows; 2^5 would be enough, and no cheaper.
struct SegmentSegment {
  static constexpr std::size_t columns = 8;
  static constexpr std::uint8_t set = 1, clear = 0;  // point, disjoint
  static Verdict of(const Lanes* c) {
    const Lanes ax = c[0], ay = c[1], bx = c[4], by = c[5];
    const Lanes rx = c[2] - ax, ry = c[3] - ay, sx = c[6] - bx, sy = c[7] - by, fx = ax - bx, fy = ay - by;
    const Lanes rs = rx * sy - ry * sx, rf = rx * fy - ry * fx, sf = sx * fy - sy * fx;
    const Lanes value = magnitude((sf + rf) - rs) + magnitude(sf - rf) - magnitude(rs);
    const Lanes ex = magnitude(rx) + magnitude(sx) + magnitude(fx), ey = magnitude(ry) + magnitude(sy) + magnitude(fy);
    const Lanes size = ex * same(0x1p8) * ey;
    return by_sign(value, multiply_add(size, same(0x1p-8 * 16 * v), same(tiny)));
  }
};

/// A product has its own rounding and at most two from sums before the last sum, which cannot make a sign wrong: the
/// value's terms are off by 3 v times the sum of their magnitudes. C = 4 v. That sum is taken in the order of the
/// value, so by monotonicity no partial sum of the value is greater than the same one of magnitudes. If no term but the
/// offset differs from 0, the normal may be zero, which is to be refused.
struct PointPlane {
  static constexpr std::size_t columns = 7;
  static constexpr std::uint8_t set = 2, clear = 0;  // back, front
  static Verdict of(const Lanes* c) {
    const Lanes x = c[0] * c[4], y = c[1] * c[5], z = c[2] * c[6], offset = c[3];
    const Lanes products = magnitude(x) + magnitude(y) + magnitude(z);
    const Lanes value = x + y + z + offset;
    Verdict found = by_sign(value, multiply_add(products + magnitude(offset), same(4 * v), same(tiny)));
    found.known &= above(products, same(0));
    return found;
  }
};

/// By the differences of robust/kernel/filters/box_differences.h, which derives them.
template <std::size_t dimensions>
struct Boxes {
  static constexpr std::size_t columns = 4 * dimensions;
  static constexpr std::uint8_t set = 0, clear = 2;  // disjoint, overlapping
  static Verdict of(const Lanes* c) {
    constexpr std::size_t n = dimensions;
    Lanes depth = same(0), extent = depth, total = depth;
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes a_min = c[k], a_max = c[n + k], b_min = c[2 * n + k], b_max = c[3 * n + k];
      const Lanes of_a = a_max - a_min, of_b = b_max - b_min;
      const Lanes own_depth = lesser(a_max, b_max) - greater(a_min, b_min), own_extent = lesser(of_a, of_b);
      depth = k == 0 ? own_depth : lesser(depth, own_depth);
      extent = k == 0 ? own_extent : lesser(extent, own_extent);
      total = k == 0 ? of_a + of_b : total + (of_a + of_b);
    }
    const Mask certain =
        not_below(same(0x1.fffffffffffffp1023), total) & above(extent, same(0)) & above(magnitude(depth), same(0));
    return {certain, negative(depth)};
  }
};

/// Let i and o be the exact squares of the sum of the radii and of the distance, I and O the computed ones: I is i with
/// three roundings, O is o with five (a difference twice, a product, two sums). As for a turn, where I - O has the
/// wrong sign it is at most 4 v (I + O). C = 8 v. Neither is negative, so no difference overflows where the sum does
/// not; an infinite or NaN coordinate makes O so, a radius I. Radii that are 0, or not valid, are left to the other
/// stages.
template <std::size_t dimensions>
struct Spheres {
  static constexpr std::size_t columns = 2 * dimensions + 2;
  static constexpr std::uint8_t set = 0, clear = 2;  // disjoint, overlapping
  static Verdict of(const Lanes* c) {
    constexpr std::size_t n = dimensions;
    const Lanes a_radius = c[n], b_radius = c[2 * n + 1];
    Lanes outside = same(0);
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes way = c[n + 1 + k] - c[k];
      outside = k == 0 ? way * way : multiply_add(way, way, outside);
    }
    const Lanes reach = a_radius + b_radius, inside = reach * reach;
    Verdict found = by_sign(inside - outside, multiply_add(inside + outside, same(8 * v), same(tiny)));
    found.known &= above(lesser(a_radius, b_radius), same(0));
    return found;
  }
};

/// On each axis the greatest of min - c, c - max and 0 is how far the center is beyond the box, off by one rounding. So
/// the square of the radius has one rounding and that of the distance five, as for two balls at most. C = 8 v. The
/// differences are rounded to 0 only where they are 0, so max - min > 0 says that the box has an interior. The
/// magnitudes of min - c and c - max add up to something finite only where all three numbers are.
template <std::size_t dimensions>
struct SphereBox {
  static constexpr std::size_t columns = 3 * dimensions + 1;
  static constexpr std::uint8_t set = 0, clear = 2;  // disjoint, overlapping
  static Verdict of(const Lanes* c) {
    constexpr std::size_t n = dimensions;
    const Lanes radius = c[n];
    Lanes outside = same(0), extent = outside, total = outside;
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes center = c[k], min = c[n + 1 + k], max = c[2 * n + 1 + k];
      const Lanes below = min - center, beyond = center - max, own_extent = max - min;
      const Lanes way = greater(greater(below, beyond), same(0));
      outside = k == 0 ? way * way : multiply_add(way, way, outside);
      extent = k == 0 ? own_extent : lesser(extent, own_extent);
      total = total + (magnitude(below) + magnitude(beyond));
    }
    const Lanes inside = radius * radius;
    Verdict found = by_sign(inside - outside, multiply_add(inside + outside, same(8 * v), same(tiny)));
    found.known &= not_below(same(0x1.fffffffffffffp1023), total) & above(extent, same(0)) & above(radius, same(0));
    return found;
  }
};

/// Separating axes, as in filters::box_relation: those of the box, which comparisons decide, and those perpendicular to
/// the ray's line and one of them, where |w_i s_j - w_j s_i| is compared with |w_i| h_j + |w_j| h_i. w is the
/// direction, s twice the origin relative to the box's center, h the box's width; one of these axes separates every ray
/// that misses a box. For two axes on which the direction is 0, the first and the second are both exactly 0.
///
/// s_j is the sum of two differences: two roundings, in units of m_j, the sum of their magnitudes. With the product and
/// the difference of products these are four, in units of |w_i| m_j + |w_j| m_i; the other products and their sum have
/// three, in units of |w_i| h_j + |w_j| h_i. The last difference cannot make a sign wrong. So a value of the wrong sign
/// is at most 4 v in units of |w_i| (m_j + h_j) + |w_j| (m_i + h_i). C = 8 v. The bound is infinite or NaN wherever a
/// sum, a width or a product is. A number that is not finite may be on an axis that does not decide: `total` asks for
/// all.
template <std::size_t dimensions>
struct RayBox {
  static constexpr std::size_t columns = 4 * dimensions;
  static constexpr std::uint8_t set = 0, clear = 1;  // none, hit

  struct OfAxis {
    Lanes way, start, size, width;
    OfAxis() = default;
    OfAxis(Lanes from, Lanes w, Lanes min, Lanes max) : way(w) {
      const Lanes above_min = from - min, above_max = from - max;
      start = above_min + above_max;
      width = max - min;
      size = magnitude(above_min) + magnitude(above_max) + magnitude(width);
    }
  };

  static Verdict of(const Lanes* c) {
    constexpr std::size_t n = dimensions;
    const Lanes zero = same(0);
    OfAxis axes[n];
    Lanes total = zero, ways = zero, narrowest = zero;
    Mask apart = 0, meets = all_lanes;
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes from = c[k], way = c[n + k], min = c[2 * n + k], max = c[3 * n + k];
      axes[k] = OfAxis(from, way, min, max);
      narrowest = k == 0 ? axes[k].width : lesser(narrowest, axes[k].width);
      ways = ways + magnitude(way);
      total = total + axes[k].size;
      apart |= (above(min, from) & not_below(zero, way)) | (above(from, max) & not_below(way, zero));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      if (j == 0 && n == 2) break;
      const OfAxis &p = axes[i], &q = axes[j];
      const Lanes value =
          magnitude(p.way * q.start - q.way * p.start) - (magnitude(p.way) * q.width + magnitude(q.way) * p.width);
      const Lanes bound = multiply_add(magnitude(p.way) * q.size + magnitude(q.way) * p.size, same(8 * v), same(tiny));
      apart |= above(value, bound);
      meets &= above(zero - value, bound) | equal(magnitude(p.way) + magnitude(q.way), zero);
    }
    const Mask valid =
        not_below(same(0x1.fffffffffffffp1023), total + ways) & above(ways, zero) & not_below(narrowest, zero);
    return {valid & (apart | meets), apart};
  }
};

template <class F>
void filter(const double* const* columns, const std::size_t* steps, std::size_t chunks, const Shared&,
            std::uint8_t* answers, std::uint64_t* unknown) {
  const double* at[F::columns];
  for (std::size_t k = 0; k < F::columns; ++k) at[k] = columns[k];
  for (std::size_t n = 0; n < chunks; ++n) {
    std::uint64_t known = 0, set = 0;
    for (std::size_t i = 0; i < chunk; i += lanes) {
      Lanes numbers[F::columns];
      for (std::size_t k = 0; k < F::columns; ++k) numbers[k] = Lanes::at(at[k] + i);
      const Verdict found = F::of(numbers);
      known |= static_cast<std::uint64_t>(found.known) << i;
      set |= static_cast<std::uint64_t>(found.set) << i;
    }
    unknown[n] = ~known;
    put_bytes(answers + n * chunk, set, F::set, F::clear);
    for (std::size_t k = 0; k < F::columns; ++k) at[k] += steps[k];
  }
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
