// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: what a unit of impulse along the normal does to both motions, the turns by elimination from I w = r x n. The
/// relative velocity along the normal is a linear function of the impulse, which is tried at 0 and at 1; where it is -e
/// times the first, that is the impulse. Nothing is decided: there is no margin.
///
/// Certificate: "impulse_at": the number `impulse` j with ma (va' - va) = j n, and `doubled_energies`, m v . v + w . I
/// w of both bodies together, before and after.
template <Exact Number = double>
Truth<Motions<Rational>> rigid_body_collision(const RigidBody<Number>& a, const RigidBody<Number>& b,
                                              const Point3<Number>& point, const Vector3<Number>& normal,
                                              const Number& e);

}  // namespace touchstone::oracle
