// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: f(t), the squared distance from the center minus the squared radius, is rational; its changes of sign,
/// forwards and backwards, count its zeros, and the first and the last are its roots. Margin: |f(t)| where it is least.
/// Certificate: "passage", where the answer is checked alone; of `none` why f is positive: it grows ("receding"), it
/// falls to the end ("too_late"), its discriminant is negative ("no_root").
template <Exact Number = double>
Truth<Passage<Surd>> segment_sphere(const Segment2<Number>& segment, const Circle2<Number>& sphere);
template <Exact Number = double>
Truth<Passage<Surd>> segment_sphere(const Segment3<Number>& segment, const Sphere3<Number>& sphere);

}  // namespace touchstone::oracle
