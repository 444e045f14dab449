// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

// Numbers of a lane each, by the same names for every instruction set:
//
//   same(x)                 x in all lanes
//   magnitude(x)            its sign cleared
//   lesser(x, y)            x < y ? x : y, so y if one is NaN; greater likewise
//   multiply_add(a, b, c)   a * b + c, rounded once or twice; once where there is a second stage
//   above, not_below, equal, negative   one bit for each lane
//   put_bytes(to, bits, set, clear)     a byte for each of 64 bits: `set` or `clear`
//
// and for second stages, where the instruction set has an FMA (TOUCHSTONE_SECOND_STAGE is defined then):
//
//   chosen(mask, x, y)                  x in the lanes of the mask, y in the others
//   where_above(x, y, then, otherwise)  `then` in the lanes in which x > y, `otherwise` in the others
//   put_answers(to, where, one, two)    the byte 1, 2 or 0 for each row of `where`, and nothing else
#if defined(__ARM_FEATURE_SVE_BITS) && TOUCHSTONE_LANES == 4
#define TOUCHSTONE_SECOND_STAGE
#include "robust/batch/isa/lanes/sve.h"
#elif TOUCHSTONE_LANES == 8
#define TOUCHSTONE_SECOND_STAGE
#include "robust/batch/isa/lanes/avx512.h"
#elif TOUCHSTONE_LANES == 4
#define TOUCHSTONE_SECOND_STAGE
#include "robust/batch/isa/lanes/avx2.h"
#elif TOUCHSTONE_LANES == 2 && defined(__aarch64__)
#define TOUCHSTONE_SECOND_STAGE
#include "robust/batch/isa/lanes/neon.h"
#elif TOUCHSTONE_LANES == 2
#include "robust/batch/isa/lanes/sse2.h"
#else
#include "robust/batch/isa/lanes/one.h"
#endif
