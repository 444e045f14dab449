// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "catalogue/codec/excerpt.h"

extern char** environ;

namespace touchstone::audit {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_errors = 4096;
constexpr std::chrono::milliseconds time_to_exit{2000};

struct Pipe {
  int to_read = -1, to_write = -1;
  Pipe() {
    int ends[2];
    // Closed on exec: another thread may be starting another engine at this moment.
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    to_read = ends[0], to_write = ends[1];
  }
  ~Pipe() {
    if (to_read >= 0) close(to_read);
    if (to_write >= 0) close(to_write);
  }
};

int taken(int& descriptor) {
  const int result = descriptor;
  descriptor = -1;
  fcntl(result, F_SETFL, fcntl(result, F_GETFL) | O_NONBLOCK);
  return result;
}

/// Makes a write into a pipe without a reader an error of this call, not the death of the program.
class NoBrokenPipeSignal {
 public:
  NoBrokenPipeSignal() {
    sigemptyset(&pipe_signal_);
    sigaddset(&pipe_signal_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_signal_, &before_);
  }
  ~NoBrokenPipeSignal() {
    const timespec none{};
    if (!was_pending_) {
      while (sigtimedwait(&pipe_signal_, nullptr, &none) == -1 && errno == EINTR) continue;
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t pipe_signal_{}, before_{};
  bool was_pending_ = false;
};

std::string signal_text(int number) {
  const char* name = sigdescr_np(number);
  return "signal " + std::to_string(number) + (name != nullptr ? " (" + std::string(name) + ")" : "");
}

std::string ending(const siginfo_t& info) {
  if (info.si_code != CLD_EXITED) return signal_text(info.si_status);
  // The exit status of a shell whose command was ended by a signal.
  if (info.si_status > 128 && info.si_status < 128 + 65) return signal_text(info.si_status - 128);
  return "exit code " + std::to_string(info.si_status);
}

std::string last_line(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  if (last == std::string_view::npos) return "";
  text = text.substr(0, last + 1);
  const std::size_t line = text.rfind('\n');
  return excerpt(line == std::string_view::npos ? text : text.substr(line + 1), 200);
}

}  // namespace

Process::Process(const std::string& command) {
  Pipe input, output, errors;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input.to_read, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output.to_write, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.to_write, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t all, none;
  sigfillset(&all), sigemptyset(&none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  const char* const arguments[] = {"sh", "-c", command.c_str(), nullptr};
  const std::string mark = std::string(started_as_engine) + "=1";
  std::vector<char*> environment{const_cast<char*>(mark.c_str())};
  for (char** variable = environ; *variable != nullptr; ++variable) environment.push_back(*variable);
  environment.push_back(nullptr);
  const int error =
      posix_spawn(&pid_, "/bin/sh", &actions, &attributes, const_cast<char* const*>(arguments), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), "/bin/sh");
  input_ = taken(input.to_write), output_ = taken(output.to_read), errors_ = taken(errors.to_read);
}

Process::~Process() {
  kill_and_reap();
  for (const int descriptor : {input_, output_, errors_}) {
    if (descriptor >= 0) close(descriptor);
  }
}

void Process::wait_for(bool to_write, Clock::time_point deadline) {
  pollfd streams[] = {{output_, POLLIN, 0}, {errors_, POLLIN, 0}, {to_write ? input_ : -1, POLLOUT, 0}};
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  poll(streams, 3, left.count() > 0 ? static_cast<int>(left.count()) : 0);
  if (streams[1].revents != 0) read_errors();
}

void Process::write(std::string_view& outbox) {
  const NoBrokenPipeSignal quietly;
  while (!outbox.empty() && input_ >= 0) {
    const ssize_t count = ::write(input_, outbox.data(), outbox.size());
    if (count > 0) {
      outbox.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      // The pipe has no reader: the state of its output decides.
      if (errno != EAGAIN) close(std::exchange(input_, -1));
      return;
    }
  }
}

void Process::close_input() {
  if (input_ >= 0) close(std::exchange(input_, -1));
}

bool Process::read(std::string& inbox) {
  constexpr std::size_t piece = 1 << 16;
  const std::size_t before = inbox.size();
  inbox.resize(before + piece);
  ssize_t count = 0;
  do count = ::read(output_, inbox.data() + before, piece);
  while (count < 0 && errno == EINTR);
  const bool open = count > 0 || (count < 0 && errno == EAGAIN);
  inbox.resize(before + static_cast<std::size_t>(count > 0 ? count : 0));
  return open;
}

void Process::read_errors() {
  char piece[kept_errors];
  // A flood of error output must not keep us from the answers.
  for (int pieces = 0; errors_ >= 0 && pieces < 64; ++pieces) {
    const ssize_t count = ::read(errors_, piece, sizeof piece);
    if (count > 0) {
      last_errors_.append(piece, static_cast<std::size_t>(count));
      if (last_errors_.size() > kept_errors) last_errors_.erase(0, last_errors_.size() - kept_errors);
    } else if (count == 0) {
      close(std::exchange(errors_, -1));
    } else if (errno != EINTR) {
      return;
    }
  }
}

std::string Process::end() {
  siginfo_t info{};
  const auto deadline = Clock::now() + time_to_exit;
  // WNOWAIT: the process must stay known until its group is killed, or its id may be reused by then.
  while (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0 &&
         Clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::string how = info.si_pid != 0 ? ending(info) : "its output ended";
  kill_and_reap();
  read_errors();
  const std::string complaint = last_line(last_errors_);
  return how.find(complaint) != std::string::npos ? how : how + ": " + complaint;
}

void Process::kill_and_reap() {
  if (pid_ < 0) return;
  kill(-pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
  pid_ = -1;
}

}  // namespace touchstone::audit
