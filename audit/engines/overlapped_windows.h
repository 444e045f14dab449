// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <windows.h>

#include <string>
#include <string_view>
#include <utility>

#include "audit/uses.h"

/// Our ends of the pipes of a process on Windows. There a pipe has no "as much as is available": an operation begins,
/// and its event is set when it has ended.
namespace touchstone::audit {

inline constexpr DWORD piece = 1 << 16;

/// Closed with this object.
class Handle {
 public:
  Handle() = default;
  explicit Handle(HANDLE handle) { reset(handle); }
  Handle(Handle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    reset(std::exchange(other.handle_, nullptr));
    return *this;
  }
  ~Handle() { reset(); }

  HANDLE get() const { return handle_; }
  explicit operator bool() const { return handle_ != nullptr; }
  void reset(HANDLE handle = nullptr) {
    if (handle_ != nullptr) CloseHandle(handle_);
    handle_ = handle == INVALID_HANDLE_VALUE ? nullptr : handle;
  }

 private:
  HANDLE handle_ = nullptr;
};

/// One operation on a pipe at a time.
class Overlapped {
 public:
  Overlapped() : event_(CreateEventA(nullptr, TRUE, TRUE, nullptr)) {}
  ~Overlapped() { shut(); }
  Overlapped(const Overlapped&) = delete;
  Overlapped& operator=(const Overlapped&) = delete;

  void open(Handle pipe) { pipe_ = std::move(pipe); }
  bool is_open() const { return static_cast<bool>(pipe_); }
  /// Set unless an operation lasts.
  HANDLE event() const { return event_.get(); }

 protected:
  enum class State { lasts, ended, failed };

  template <class Operation>
  bool begin(const Operation& operation) {
    overlapped_ = {};
    overlapped_.hEvent = event_.get();
    begun_ = operation(pipe_.get(), &overlapped_) != 0 || GetLastError() == ERROR_IO_PENDING;
    if (!begun_) shut();
    return begun_;
  }
  State state(DWORD& count) {
    if (GetOverlappedResult(pipe_.get(), &overlapped_, &count, FALSE) != 0) {
      begun_ = false;
      return State::ended;
    }
    if (GetLastError() == ERROR_IO_INCOMPLETE) return State::lasts;
    begun_ = false;
    shut();
    return State::failed;
  }
  bool begun() const { return begun_; }
  /// Closes the pipe. The event stays set: waiting for it ends at once.
  void shut() {
    DWORD ignored = 0;
    if (begun_ && CancelIoEx(pipe_.get(), &overlapped_) != 0)
      GetOverlappedResult(pipe_.get(), &overlapped_, &ignored, TRUE);
    begun_ = false;
    pipe_.reset();
    SetEvent(event_.get());
  }

 private:
  Handle pipe_, event_;
  OVERLAPPED overlapped_{};
  bool begun_ = false;
};

/// The pipe that the process writes.
class Output : public Overlapped {
 public:
  ~Output() { shut(); }
  void open(Handle pipe) {
    Overlapped::open(std::move(pipe));
    ask();
  }
  /// Appends what is available. Returns false once it has ended.
  bool read(std::string& inbox) {
    if (!is_open()) return false;
    DWORD count = 0;
    switch (state(count)) {
      case State::lasts: return true;
      case State::failed: return false;
      case State::ended: break;
    }
    inbox.append(bytes_, count);
    ask();
    return true;
  }

 private:
  void ask() {
    begin([&](HANDLE pipe, OVERLAPPED* how) { return ReadFile(pipe, bytes_, piece, nullptr, how); });
  }
  char bytes_[piece];
};

/// The pipe that the process reads.
class Input : public Overlapped {
 public:
  ~Input() { shut(); }
  bool is_closing() const { return closing_; }

  /// Takes as much as the pipe may hold, and removes it from `outbox`.
  void write(std::string_view& outbox) {
    advance();
    while (is_open() && !closing_ && !begun() && !outbox.empty()) {
      bytes_ = outbox.substr(0, piece);
      const auto size = static_cast<DWORD>(bytes_.size());
      if (begin([&](HANDLE pipe, OVERLAPPED* how) { return WriteFile(pipe, bytes_.data(), size, nullptr, how); }))
        outbox.remove_prefix(size);
      advance();
    }
  }
  /// Closes the pipe when all is written that it was given.
  void close() {
    closing_ = true;
    advance();
  }
  /// Notices the end of an operation.
  void advance() {
    DWORD count = 0;
    if (is_open() && begun() && state(count) == State::lasts) return;
    if (is_open() && closing_) shut();
  }

 private:
  std::string bytes_;
  bool closing_ = false;
};

}  // namespace touchstone::audit
