// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <optional>
#include <utility>

namespace touchstone::catalogue {

/// A value that is made on first use. An exception thrown then is thrown again. Not thread-safe.
template <class T>
class Once {
 public:
  Once() = default;
  explicit Once(T value) : value_(std::move(value)) {}

  template <class Make>
  const T& value(const Make& make) const {
    if (thrown_) std::rethrow_exception(thrown_);
    if (!value_) {
      try {
        value_.emplace(make());
      } catch (...) {
        thrown_ = std::current_exception();
        throw;
      }
    }
    return *value_;
  }

 private:
  mutable std::optional<T> value_;
  mutable std::exception_ptr thrown_;
};

}  // namespace touchstone::catalogue
