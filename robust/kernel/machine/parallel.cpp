// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/machine/parallel.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace touchstone::robust {

std::size_t threads_of_machine() { return std::max(1u, std::thread::hardware_concurrency()); }

void kernel::on_threads(std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex failure_mutex;
  std::exception_ptr failure;
  std::size_t failed = count;
  const auto some = [&] {
    for (std::size_t i; (i = next.fetch_add(1)) < count;) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (i < failed) failure = std::current_exception(), failed = i;
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  try {
    for (std::size_t i = 1; i < std::min(count, threads); ++i) others.emplace_back(some);
  } catch (const std::system_error&) {  // continues with those that have started
  }
  some();
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace touchstone::robust
