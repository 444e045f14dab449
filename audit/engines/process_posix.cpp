// SPDX-License-Identifier: Apache-2.0
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

#include "audit/engines/last_errors.h"
#include "audit/engines/process.h"

extern char** environ;

namespace touchstone::audit {
namespace {

using Clock = std::chrono::steady_clock;

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

}  // namespace

struct Process::Running {
  pid_t pid = -1;
  int input = -1, output = -1, errors = -1;
  LastErrors last_errors;

  ~Running() {
    kill_and_reap();
    for (const int descriptor : {input, output, errors}) {
      if (descriptor >= 0) close(descriptor);
    }
  }
  void read_errors();
  void kill_and_reap();
};

Process::Process(const std::string& command) : running_(std::make_unique<Running>()) {
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
  const int error = posix_spawn(&running_->pid, "/bin/sh", &actions, &attributes, const_cast<char* const*>(arguments),
                                environment.data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), "/bin/sh");
  running_->input = taken(input.to_write), running_->output = taken(output.to_read);
  running_->errors = taken(errors.to_read);
}

Process::~Process() = default;

void Process::wait_for(bool to_write, Clock::time_point deadline) {
  pollfd streams[] = {
      {running_->output, POLLIN, 0}, {running_->errors, POLLIN, 0}, {to_write ? running_->input : -1, POLLOUT, 0}};
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  poll(streams, 3, left.count() > 0 ? static_cast<int>(left.count()) : 0);
  if (streams[1].revents != 0) running_->read_errors();
}

void Process::write(std::string_view& outbox) {
  const NoBrokenPipeSignal quietly;
  while (!outbox.empty() && running_->input >= 0) {
    const ssize_t count = ::write(running_->input, outbox.data(), outbox.size());
    if (count > 0) {
      outbox.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      // The pipe has no reader: the state of its output decides.
      if (errno != EAGAIN) close(std::exchange(running_->input, -1));
      return;
    }
  }
}

void Process::close_input() {
  if (running_->input >= 0) close(std::exchange(running_->input, -1));
}

bool Process::read(std::string& inbox) {
  constexpr std::size_t piece = 1 << 16;
  const std::size_t before = inbox.size();
  inbox.resize(before + piece);
  ssize_t count = 0;
  do count = ::read(running_->output, inbox.data() + before, piece);
  while (count < 0 && errno == EINTR);
  const bool open = count > 0 || (count < 0 && errno == EAGAIN);
  inbox.resize(before + static_cast<std::size_t>(count > 0 ? count : 0));
  return open;
}

void Process::Running::read_errors() {
  char piece[LastErrors::kept];
  // A flood of error output must not keep us from the answers.
  for (int pieces = 0; errors >= 0 && pieces < 64; ++pieces) {
    const ssize_t count = ::read(errors, piece, sizeof piece);
    if (count > 0) {
      last_errors.append({piece, static_cast<std::size_t>(count)});
    } else if (count == 0) {
      close(std::exchange(errors, -1));
    } else if (errno != EINTR) {
      return;
    }
  }
}

std::string Process::end() {
  siginfo_t info{};
  const auto deadline = Clock::now() + time_to_exit;
  // WNOWAIT: the process must stay known until its group is killed, or its id may be reused by then.
  while (waitid(P_PID, static_cast<id_t>(running_->pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0 &&
         Clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const std::string how = info.si_pid != 0 ? ending(info) : "its output ended";
  running_->kill_and_reap();
  running_->read_errors();
  return running_->last_errors.after(how);
}

void Process::Running::kill_and_reap() {
  if (pid < 0) return;
  kill(-pid, SIGKILL);
  while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) continue;
  pid = -1;
}

}  // namespace touchstone::audit
