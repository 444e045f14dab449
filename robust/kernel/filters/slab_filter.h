// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/volumes.h"
#include "robust/kernel/filters/filters.h"

/// The first stage for slabs: the model, the guards and the rules (4) and (5) of filters.h.
namespace touchstone::robust::filters {

/// The depth of a point in slabs: the least n . p - min and max - n . p over all of them, which decides alone.
///
/// Each of these is what robust/kernel/filters/plane_filter.h computes of a plane. A wrong sign of one is at most (1 +
/// u) ((1 + u)^3 - 1) times the sum of its products' magnitudes, and that is at most the greatest sum of a normal's
/// magnitudes times that of the point's. That product is computed with one operation less than there, no offset being
/// added, so C = 3 u + 48 u^2 is enough, and A pays for underflow as there. Greatest and least do not round.
///
/// No slab is tested individually, so that the loop is the only branch. Invalid slabs show in the least of the normals'
/// sums (0: perhaps a zero normal), in the least width (0: perhaps flat, below: min > max), and in a sum over all
/// slabs, which NaN and infinities never leave; overflow of finite numbers only costs time.
///
/// If DAZ makes comparisons read zeros, the least may differ from the true one, or be kept as zero (x86's minimum does
/// that), but then both are below n, and A covers that too. That every slab is valid, though, requires all operations
/// of a call to treat subnormals alike: if one comparison read the sums 0 and n / 2 of two normals as zeros, and the
/// last one did not, n / 2 could hide the 0. One control word for the entire call guarantees that. Proved, for any
/// number of slabs, by slab_right.
template <class Float, class Format = FloatFormat<Float>>
class SlabDepths {
 public:
  SlabDepths(const Point3<Float>& p, const Vector3<Float>& n, const Slab<Float>& slab) : p_(p) {
    const Found first = found(n, slab);
    depth_ = first.depth, width_ = first.width, least_ = greatest_ = first.of_normal, sum_ = first.difference;
  }
  void add(const Vector3<Float>& n, const Slab<Float>& slab) {
    const Found next = found(n, slab);
    depth_ = lesser(depth_, next.depth), width_ = lesser(width_, next.width), least_ = lesser(least_, next.of_normal);
    greatest_ = next.of_normal > greatest_ ? next.of_normal : greatest_;
    sum_ = sum_ + next.difference;
  }

  /// Positive: strictly within all slabs; negative: beyond an end of one. Certain only if all of them are valid.
  Sign sign() const {
    using B = Bounds<Float, Format>;
    const Float of_point = extent<Float, Format>(p_.x, p_.y, p_.z);
    const Float bound = B::template relative<6, 48>() * (greatest_ * of_point) + B::absolute();
    const int known = Format::magnitude(depth_) > bound, guarded = greatest_ + of_point <= B::high(),
              normals = least_ > Float(), wide = width_ > Float(), finite = sum_ - sum_ <= Float();
    if ((known & guarded & normals & wide & finite) == 0) [[unlikely]]  // one branch
      return Sign::unknown;
    return depth_ > Float() ? Sign::positive : Sign::negative;
  }

 private:
  struct Found {
    Float depth, width, of_normal, difference;
  };
  static Float lesser(const Float& x, const Float& y) { return x < y ? x : y; }
  Found found(const Vector3<Float>& n, const Slab<Float>& slab) const {
    const Float value = n.x * p_.x + n.y * p_.y + n.z * p_.z, over = value - slab.min, under = slab.max - value;
    return {lesser(over, under), slab.max - slab.min, extent<Float, Format>(n.x, n.y, n.z), over - under};
  }

  Point3<Float> p_;
  Float depth_, width_, least_, greatest_, sum_;
};

/// The values of one slab.
template <class Float, class Format = FloatFormat<Float>>
Sign slab(const Vector3<Float>& n, const Slab<Float>& slab, const Point3<Float>& p) {
  return SlabDepths<Float, Format>(p, n, slab).sign();
}

}  // namespace touchstone::robust::filters
