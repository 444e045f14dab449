// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifndef __SIZEOF_INT128__
#include "geometry/two_words.h"
#endif

namespace touchstone {

/// Integers of 128 bits. The compiler's are without a standard: 32-bit processors and MSVC have none.
#ifdef __SIZEOF_INT128__
__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;
#else
using Int128 = TwoWords<true>;
using UInt128 = TwoWords<false>;
#endif

}  // namespace touchstone
