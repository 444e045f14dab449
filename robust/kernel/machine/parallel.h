// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "robust/kernel/filters/control_word.h"

namespace touchstone::robust {

/// The number of threads that the machine can run at once.
std::size_t threads_of_machine();

namespace kernel {

/// As in_parallel, for at least two threads.
void on_threads(std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace kernel

/// Calls work(0) ... work(count - 1), each once, on up to `threads` threads, or as many as the machine grants; on one,
/// in order. If calls throw, running calls finish, no new ones begin, and the exception of the least number is rethrown
/// to the caller, which is the same for any number of threads if the same calls throw.
template <class Work>
void in_parallel(std::size_t threads, std::size_t count, const Work& work) {
  if (std::min(threads, count) > 1) return kernel::on_threads(threads, count, work);
  for (std::size_t i = 0; i < count; ++i) work(i);
}

namespace kernel {

/// Consecutive parts of `count` elements, one for each of up to `threads` threads, but none of less than `least`.
class ThreadParts {
 public:
  ThreadParts(std::size_t threads, std::size_t count, std::size_t least)
      : count_(count), size_(std::clamp<std::size_t>(count / least, 1, std::max<std::size_t>(threads, 1))) {}

  std::size_t size() const { return size_; }

  /// Calls work(part, first, end) of each part, in IEEE arithmetic.
  template <class Work>
  void each(const Work& work) const {
    in_parallel(size_, size_, [&](std::size_t part) {
      const ControlWord guard;
      work(part, start(part), start(part + 1));
    });
  }

 private:
  std::size_t start(std::size_t part) const { return part == size_ ? count_ : count_ / size_ * part; }

  std::size_t count_, size_;
};

}  // namespace kernel
}  // namespace touchstone::robust
