// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/thin_shapes.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the least t of the linear program in t and a common point p: 0 <= t <= 1, p in b, p - t velocity in a;
/// `never` where Farkas' lemma contradicts it.
///
/// Margin: a length, how far a has to be moved in the maximum norm until the relation changes. Each inequality of one
/// axis, low - t v <= 0 or t v - high <= 0, is a line over t. Where two lines of different axes, one of which falls and
/// the other rises, meet, neither is lower than that before and after; the least value in [0, 1] of a line alone counts
/// too. The greatest of all these values is positive where the boxes never meet, and then it is their least distance;
/// otherwise its magnitude is the distance to leave. (Two lines of one axis meet half of both extents below 0, where
/// only invalid boxes would get.)
///
/// Certificate: hit: a common `point` at t, and unless t is 0 ("start") a `normal` along which a touches b then and
/// approaches it ("first_contact"). never: a `normal` along which a is before b at the start and at the end
/// ("separating_axis").
template <Exact Number = double>
Truth<FirstContact<Rational>> swept_aabb_aabb(const Aabb2<Number>& a, const Aabb2<Number>& b,
                                              const Vector2<Number>& velocity);
template <Exact Number = double>
Truth<FirstContact<Rational>> swept_aabb_aabb(const Aabb3<Number>& a, const Aabb3<Number>& b,
                                              const Vector3<Number>& velocity);

}  // namespace touchstone::oracle
