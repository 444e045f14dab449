// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/sweeps/swept_sphere_sphere.h. Right, and t correctly rounded, for all finite doubles in every
/// floating-point environment.
FirstContact<double> swept_sphere_sphere(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                         const Vector3d& velocity_b);

/// The same, and which stage decided.
FirstContact<double> swept_sphere_sphere(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                         const Vector3d& velocity_b, Stage& decided);

/// The decision alone; and which stage decided.
HitRelation swept_sphere_sphere_relation(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                         const Vector3d& velocity_b);
HitRelation swept_sphere_sphere_relation(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                         const Vector3d& velocity_b, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer. The filter of the whole answer knows the
/// sweeps that hit at the start, and those that never do: no number has to be found.
std::optional<FirstContact<double>> swept_sphere_sphere_filter(const Sphere3d& a, const Sphere3d& b,
                                                               const Vector3d& velocity_a, const Vector3d& velocity_b);
std::optional<FirstContact<double>> swept_sphere_sphere_lattice(const Sphere3d& a, const Sphere3d& b,
                                                                const Vector3d& velocity_a, const Vector3d& velocity_b);
FirstContact<double> swept_sphere_sphere_exact(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                               const Vector3d& velocity_b);
std::optional<HitRelation> swept_sphere_sphere_relation_filter(const Sphere3d& a, const Sphere3d& b,
                                                               const Vector3d& velocity_a, const Vector3d& velocity_b);
std::optional<HitRelation> swept_sphere_sphere_relation_lattice(const Sphere3d& a, const Sphere3d& b,
                                                                const Vector3d& velocity_a, const Vector3d& velocity_b);
HitRelation swept_sphere_sphere_relation_exact(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                               const Vector3d& velocity_b);

}  // namespace touchstone::robust
