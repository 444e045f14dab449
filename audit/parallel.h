// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "audit/uses.h"

namespace touchstone::audit {

/// Calls work(0) ... work(count - 1), each once, on up to `jobs` threads, or as many as the machine grants. If a call
/// throws, running calls finish, no new ones begin, and the first exception is rethrown to the caller.
void in_parallel(int jobs, std::size_t count, const std::function<void(std::size_t)>& work);

/// The number of jobs that the machine can run at once.
int jobs_of_machine();

}  // namespace touchstone::audit
