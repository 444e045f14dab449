// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::sphere_sphere of each a and b, in the plane or in space, its Contact: disjoint 0, touching 1, overlapping 2.
void sphere_sphere(const Spheres2& a, const Spheres2& b, std::size_t count, std::uint8_t* answers,
                   const Limits& limits = {});
void sphere_sphere(const Spheres3& a, const Spheres3& b, std::size_t count, std::uint8_t* answers,
                   const Limits& limits = {});

}  // namespace touchstone::robust::batch
