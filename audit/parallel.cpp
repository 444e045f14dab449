// SPDX-License-Identifier: Apache-2.0
#include "audit/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace touchstone::audit {

void in_parallel(int jobs, std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex failure_mutex;
  std::exception_ptr failure;
  const auto some = [&] {
    try {
      for (std::size_t i; (i = next.fetch_add(1)) < count;) work(i);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> others;
  try {
    for (std::size_t i = 1; i < std::min(count, static_cast<std::size_t>(std::max(jobs, 1))); ++i)
      others.emplace_back(some);
  } catch (const std::system_error&) {  // continues with those that have started
  }
  some();
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

int jobs_of_machine() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

}  // namespace touchstone::audit
