// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// An axis: the cross product of two of the six edges, a's before b's; and the four others. First the normals of
/// a's faces, then of b's, then of an edge of a and an edge of b.
struct Spanned {
  std::size_t v, w;
  std::array<std::size_t, 4> others;
};
inline constexpr std::array<Spanned, 15> axes_of_boxes{{{1, 2, {0, 3, 4, 5}},
                                                        {2, 0, {1, 3, 4, 5}},
                                                        {0, 1, {2, 3, 4, 5}},
                                                        {4, 5, {3, 0, 1, 2}},
                                                        {5, 3, {4, 0, 1, 2}},
                                                        {3, 4, {5, 0, 1, 2}},
                                                        {0, 3, {1, 2, 4, 5}},
                                                        {0, 4, {1, 2, 3, 5}},
                                                        {0, 5, {1, 2, 3, 4}},
                                                        {1, 3, {0, 2, 4, 5}},
                                                        {1, 4, {0, 2, 3, 5}},
                                                        {1, 5, {0, 2, 3, 4}},
                                                        {2, 3, {0, 1, 4, 5}},
                                                        {2, 4, {0, 1, 3, 5}},
                                                        {2, 5, {0, 1, 3, 4}}}};

}  // namespace touchstone::robust::kernel
