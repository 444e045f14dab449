// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/face_filter.h"

/// The first stage for parallelepipeds: the model and the rules (1), (4) and (5) of filters.h, the guard H and the
/// absolute term of face_filter.h.
///
/// An axis n = v x w is asked for the sign of |n . d| - sum |n . e|, where d is a computed difference and the e are up
/// to four vectors of the input. With |x| for the sum of the magnitudes of a vector's coordinates, let S = |d| + sum
/// |e| and P = |v| |w| S, taken exactly: P is at least the sum of the magnitudes of all products of three coordinates.
/// Such a product goes through a difference (in d), a product and a difference in n, a product, at most two sums, and
/// at most three sums more: at most eight roundings, the last of which is shared and cannot make a sign wrong by (4).
/// So a value of the wrong sign is at most (1 + u) ((1 + u)^7 - 1) P (FMA only leaves roundings out).
///
/// The bound: |v| and |w| lose two roundings each, S at most six (two within a size, three between six of them, and one
/// with that of d), products three, the absolute term one: C (1 - u)^14 >= (1 + u) ((1 + u)^7 - 1) = 7 u + .... At u =
/// 1/16, 3.169 in units of 7 u: 7 u + 243 u^2 would do. C = 8 u + 384 u^2. (Looser by more than that: P holds 27
/// products for every six there are, and terms that have a sign in common are taken for as large as they can be.)
///
/// Guard: a sum of sizes that contains S, |v| and |w| is at most H, as computed: every number is at most H in
/// magnitude, and every product of three and every sum of such at most H^3.
///
/// Absolute terms, for u <= 1/16 and H >= 2, in units of n H^2: reading numbers as zero and flushing results make the
/// three coordinates of the normal off by less than 7 / H each (by n (|v| + |w|) and 5 n, times (1 + u)^2), and their
/// magnitudes add up to at most 0.3 H^2. In the dot products with d and all e together: 7 for the normal's error, 1.5
/// for these vectors read as zero, 1 for the normal read as zero, 1.3 for the difference in d, 12 for products and
/// sums, 3 for the sums of magnitudes, all times (1 + u)^6 = 1.44: less than 38. The bound: |v| and |w| are off by less
/// than 9 n, S by less than 140 n: 18 and 35, times C <= 2; and 6 for its products. Less than 151 together, and 512
/// times 1 - u pays for it. (The proofs count more roughly, each coordinate as H and not their sum: 271.)
namespace touchstone::robust::filters {

/// The sum of the magnitudes of its coordinates.
template <class Float, class Format = FloatFormat<Float>>
Float size_of(const Vector3<Float>& v) {
  return extent<Float, Format>(v.x, v.y, v.z);
}

template <class Float, class Format = FloatFormat<Float>>
struct AxisBounds {
  static Float high() { return CubicBounds<Float, Format>::high(); }
  /// The error bound of |n . d| - sum |n . e| for n = v x w.
  static Float error(const Float& size_of_v, const Float& size_of_w, const Float& sum_of_sizes) {
    return Bounds<Float, Format>::template relative<16, 384>() * (size_of_v * size_of_w * sum_of_sizes) +
           CubicBounds<Float, Format>::absolute();
  }
};

/// Locates a point relative to a parallelepiped, unless it is too near to a face's plane. Unknown if the half axes may
/// be dependent: n . u is the same for every half axis u and the normal n of the other two, and bounded like the
/// values. Proved.
template <class Float, class Format = FloatFormat<Float>>
Perhaps<Location> point_in_obb(const Obb3<Float>& box, const Point3<Float>& point) {
  using B = AxisBounds<Float, Format>;
  const auto& [u, v, w] = box.half_axes;
  const Vector3<Float> d = point - box.center;
  const Float size_u = size_of<Float, Format>(u), size_v = size_of<Float, Format>(v),
              size_w = size_of<Float, Format>(w), sum = size_of<Float, Format>(d) + (size_u + size_v + size_w);
  const Vector3<Float> across_u = cross(v, w), across_v = cross(w, u), across_w = cross(u, v);
  const Float volume = Format::magnitude(dot(across_u, u));
  const Float along_u = Format::magnitude(dot(across_u, d)) - volume,
              along_v = Format::magnitude(dot(across_v, d)) - volume,
              along_w = Format::magnitude(dot(across_w, d)) - volume;
  const Float error_u = B::error(size_v, size_w, sum), error_v = B::error(size_w, size_u, sum),
              error_w = B::error(size_u, size_v, sum);
  if (!(sum <= B::high()) || !(volume > error_u)) [[unlikely]]
    return std::nullopt;
  const Float zero = Float();
  const int beyond =
      static_cast<int>(along_u > error_u) | static_cast<int>(along_v > error_v) | static_cast<int>(along_w > error_w);
  if (beyond != 0) return Location::outside;
  const int within = static_cast<int>(zero - along_u > error_u) & static_cast<int>(zero - along_v > error_v) &
                     static_cast<int>(zero - along_w > error_w);
  if (within != 0) return Location::inside;
  return std::nullopt;
}

/// Decides whether axes separate two parallelepipeds. edges: the half axes of one and then of the other; way: the
/// computed difference of the centers.
template <class Float, class Format = FloatFormat<Float>>
class ObbAxes {
  using B = AxisBounds<Float, Format>;

 public:
  ObbAxes(const std::array<Vector3<Float>, 6>& edges, const Vector3<Float>& way) : edges_(edges), way_(way) {
    for (std::size_t i = 0; i < 6; ++i) sizes_[i] = size_of<Float, Format>(edges[i]);
    sum_ = size_of<Float, Format>(way) + ((sizes_[0] + sizes_[1] + sizes_[2]) + (sizes_[3] + sizes_[4] + sizes_[5]));
  }

  /// True if the half axes of either are certainly independent, given the guard; checked with every axis. Proved:
  /// obb_volume, if an axis is certain.
  bool independent() const { return volume_is_certain(0) && volume_is_certain(3); }

  /// The sign for the axis n = v x w of edges number v and w, to which these two contribute nothing: positive if it
  /// separates, negative if the boxes have a common interval of positive length along it. Proved for any four different
  /// others: obb_axis, about the values of obb_axes.
  Sign on_axis(std::size_t v, std::size_t w, const std::array<std::size_t, 4>& others) const {
    const Vector3<Float> n = cross(edges_[v], edges_[w]);
    const auto along = [&n](const Vector3<Float>& x) { return Format::magnitude(dot(n, x)); };
    const Float reach =
        (along(edges_[others[0]]) + along(edges_[others[1]])) + (along(edges_[others[2]]) + along(edges_[others[3]]));
    const Float error = B::error(sizes_[v], sizes_[w], sum_);
    return certain<Float, Format>(along(way_) - reach, error, sum_, B::high());
  }

 private:
  bool volume_is_certain(std::size_t i) const {
    const Float volume = dot(cross(edges_[i], edges_[i + 1]), edges_[i + 2]);
    return Format::magnitude(volume) > B::error(sizes_[i], sizes_[i + 1], sum_);
  }

  const std::array<Vector3<Float>, 6>& edges_;
  Vector3<Float> way_;
  std::array<Float, 6> sizes_;
  Float sum_;
};

}  // namespace touchstone::robust::filters
