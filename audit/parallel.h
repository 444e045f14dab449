// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "audit/uses.h"

namespace touchstone::audit {

/// Calls work(0) ... work(count - 1), each once, on up to `jobs` threads, or as many as the machine grants. When a call
/// throws, what has begun runs to its end, soon nothing else is begun, and the first exception goes to the caller.
void in_parallel(int jobs, std::size_t count, const std::function<void(std::size_t)>& work);

/// As many jobs as the machine can do at once.
int jobs_of_machine();

}  // namespace touchstone::audit
