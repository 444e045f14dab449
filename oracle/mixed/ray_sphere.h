// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: f(t), the squared distance from the center minus the squared radius, is rational; its changes of sign,
/// forwards and backwards, count its zeros, and the first and the last are its roots. Margin: |f(t)| where it is least.
/// Certificate: "passage", where the answer is checked alone; of `none` why f is positive: it grows ("receding"), its
/// discriminant is negative ("no_root").
template <Exact Number = double>
Truth<Passage<Surd>> ray_sphere(const Ray2<Number>& ray, const Circle2<Number>& sphere);
template <Exact Number = double>
Truth<Passage<Surd>> ray_sphere(const Ray3<Number>& ray, const Sphere3<Number>& sphere);

}  // namespace touchstone::oracle
