// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// A hint for memory that is about to be written for the first time: in pages of 2 MiB that costs a fraction of what it
/// costs in pages of 4 KiB, two microseconds each. Small memory, and other systems than Linux, are left as they are.
inline void in_large_pages([[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  constexpr std::size_t page = std::size_t{1} << 21;
  const auto first = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
  const auto last = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

/// A vector of elements of value 0 in such memory.
template <class Element>
std::vector<Element> zeros_in_large_pages(std::size_t count) {
  std::vector<Element> zeros;
  zeros.reserve(count);
  in_large_pages(zeros.data(), count * sizeof(Element));
  zeros.resize(count);
  return zeros;
}

}  // namespace touchstone::robust::kernel
