// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/polyhedra.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the least t of the linear program in t, the weights of a's vertices and those of b's, each not negative and
/// with sum 1, whose points meet: a's, moved by t velocity, and b's; `never` where Farkas' lemma contradicts it.
///
/// Margin: a length, how far a has to be moved in the maximum norm until the relation changes, by linear programs too.
/// Never: the least size of a displacement with which they meet. Hit: displacements with which they meet are convex, so
/// that a cube of them is all right where its corners are: the least, over the eight corners of a cube around 0, of how
/// far a can be moved towards it and still meets b.
///
/// Certificate: hit: a common `point` at t, and unless t is 0 ("start") a `normal` along which a touches b then and
/// approaches it ("first_contact"), by a linear program of its own. never: a `normal` along which a is before b at the
/// start and at the end ("separating_axis"), from Farkas' lemma.
template <Exact Number = double>
Truth<FirstContact<Rational>> swept_convex_polyhedra(const Mesh<Number>& a, const Mesh<Number>& b,
                                                     const Vector3<Number>& velocity);

}  // namespace touchstone::oracle
