// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include "audit/uses.h"
#include "robust/kernel/machine/parallel.h"

namespace touchstone::audit {

/// robust::in_parallel, on one thread if `jobs` is less.
template <class Work>
void in_parallel(int jobs, std::size_t count, const Work& work) {
  robust::in_parallel(static_cast<std::size_t>(std::max(jobs, 1)), count, work);
}

/// The number of jobs that the machine can run at once.
inline int jobs_of_machine() { return static_cast<int>(robust::threads_of_machine()); }

}  // namespace touchstone::audit
