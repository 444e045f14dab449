// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/sweeps/swept_sphere_sphere.h"

namespace touchstone::robust::stages {

/// The filter of the whole answer knows the sweeps that hit at the start, and those that never do: no number has to be
/// found.
struct swept_sphere_sphere {
  using Answer = FirstContact<double>;
  static Perhaps<Answer> filter(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb);
  static Perhaps<Answer> enclosed(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb);
  static Perhaps<Answer> lattice(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb);
  static Answer exact(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb);
  static Decided<Answer> ask(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb);

  struct decision {
    static Perhaps<HitRelation> filter(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb);
    static Perhaps<HitRelation> lattice(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb);
    static HitRelation exact(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb);
    static Decided<HitRelation> ask(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb);
  };
};

}  // namespace touchstone::robust::stages
