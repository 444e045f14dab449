// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/face_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// The sign of ((b - a) x (c - a)) . (p - a): 1 if p lies on the side of the plane from which a, b, c are seen
/// counter-clockwise, 0 on the plane (or if a, b, c are collinear). Right for all finite doubles in every
/// floating-point environment. staged.h describes the stages.
struct SideOfFace {
  static Perhaps<int> lattice(const Point3d& a, const Point3d& b, const Point3d& c, const Point3d& p);
  static int exact(const Point3d& a, const Point3d& b, const Point3d& c, const Point3d& p);
};

/// A face of a mesh, for many points p. The mesh must be valid and outlive it.
class FaceSide {
 public:
  FaceSide(const Meshd& mesh, const Face& face)
      : a_(mesh.vertices[face.a]), b_(mesh.vertices[face.b]), c_(mesh.vertices[face.c]), filter_(a_, b_, c_) {}

  /// 0 if the filter does not tell.
  int surely(const Point3d& p) const {
    const auto side = filters::by_sign(filter_.side(p), 1, -1);
    return side ? *side : 0;
  }
  Decided<int> of(const Point3d& p) const {
    if (const auto side = filters::by_sign(filter_.side(p), 1, -1)) return {*side, Stage::filter};
    return past_filter(p);
  }

 private:
  Decided<int> past_filter(const Point3d& p) const;

  const Point3d &a_, &b_, &c_;
  filters::FacePlane<double> filter_;
};

}  // namespace touchstone::robust::kernel
