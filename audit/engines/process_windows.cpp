// SPDX-License-Identifier: Apache-2.0
#include <windows.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "audit/engines/last_errors.h"
#include "audit/engines/overlapped_windows.h"
#include "audit/engines/process.h"
#include "audit/platform.h"

namespace touchstone::audit {
namespace {

using Clock = std::chrono::steady_clock;

constexpr DWORD time_to_exit = 2000;

std::system_error failure(const std::string& what) {
  return {static_cast<int>(GetLastError()), std::system_category(), what};
}

/// A pipe with a name of its own, since only those can be read and written without waiting. The other end is inherited.
struct Pipe {
  Handle ours, theirs;
  explicit Pipe(bool to_read) {
    static std::atomic<unsigned> number{0};
    const std::string name = R"(\\.\pipe\touchstone.)" + process_number() + "." + std::to_string(number++);
    const DWORD direction = to_read ? PIPE_ACCESS_INBOUND : PIPE_ACCESS_OUTBOUND;
    ours.reset(CreateNamedPipeA(name.c_str(), direction | FILE_FLAG_OVERLAPPED | FILE_FLAG_FIRST_PIPE_INSTANCE,
                                PIPE_TYPE_BYTE | PIPE_REJECT_REMOTE_CLIENTS, 1, piece, piece, 0, nullptr));
    if (!ours) throw failure("pipe");
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    theirs.reset(CreateFileA(name.c_str(), to_read ? GENERIC_WRITE : GENERIC_READ, 0, &inherited, OPEN_EXISTING,
                             FILE_ATTRIBUTE_NORMAL, nullptr));
    if (!theirs) throw failure("pipe");
  }
};

/// A process inherits these handles and no others, for another thread may be starting another engine.
class Inherited {
 public:
  explicit Inherited(std::array<HANDLE, 3> handles) : handles_(handles) {
    SIZE_T size = 0;
    InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
    bytes_.resize(size);
    if (InitializeProcThreadAttributeList(list(), 1, 0, &size) == 0) throw failure("a list of handles");
    if (UpdateProcThreadAttribute(list(), 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, handles_.data(), sizeof handles_,
                                  nullptr, nullptr) == 0)
      throw failure("a list of handles");
  }
  ~Inherited() { DeleteProcThreadAttributeList(list()); }
  Inherited(const Inherited&) = delete;
  Inherited& operator=(const Inherited&) = delete;
  LPPROC_THREAD_ATTRIBUTE_LIST list() { return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(bytes_.data()); }

 private:
  std::array<HANDLE, 3> handles_;
  std::vector<char> bytes_;
};

/// Our environment, marked.
std::string environment() {
  std::string all = std::string(started_as_engine) + "=1" + '\0';
  char* const ours = GetEnvironmentStringsA();
  if (ours == nullptr) throw failure("environment");
  for (const char* variable = ours; *variable != 0;) {
    const std::string_view text = variable;
    all.append(text) += '\0';
    variable += text.size() + 1;
  }
  FreeEnvironmentStringsA(ours);
  return all + '\0';
}

/// A job whose processes end with its last handle.
HANDLE made_job() {
  const HANDLE job = CreateJobObjectA(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  if (job == nullptr || SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits) == 0)
    throw failure("job");
  return job;
}

struct Exception {
  DWORD code;
  const char* name;
};
constexpr Exception exceptions[] = {
    {0xc0000005, "access violation"},        {0xc000001d, "illegal instruction"},
    {0xc000008e, "division by zero"},        {0xc0000090, "invalid operation"},
    {0xc0000094, "division by zero"},        {0xc00000fd, "stack overflow"},
    {0xc0000135, "a library was not found"}, {0xc000013a, "Ctrl+C"},
    {0xc0000374, "heap corruption"},         {0xc0000409, "stack buffer overrun"},
};

std::string ending(DWORD code) {
  constexpr DWORD error_severity = 0xc0000000;
  if (code < error_severity) return "exit code " + std::to_string(code);
  constexpr const char* digits = "0123456789abcdef";
  std::string hex;
  for (int shift = 28; shift >= 0; shift -= 4) hex += digits[code >> shift & 15];
  const auto* const known =
      std::find_if(std::begin(exceptions), std::end(exceptions), [&](const Exception& e) { return e.code == code; });
  return "exception 0x" + hex + (known != std::end(exceptions) ? " (" + std::string(known->name) + ")" : "");
}

}  // namespace

struct Process::Running {
  Handle job, process;
  std::string not_started;
  Output output, errors;
  Input input;
  LastErrors last_errors;

  ~Running() { kill(); }
  void read_errors() {
    // A flood of error output must not keep us from the answers.
    std::string piece_of_errors;
    for (int pieces = 0; pieces < 64 && errors.read(piece_of_errors) && !piece_of_errors.empty(); ++pieces) {
      last_errors.append(piece_of_errors);
      piece_of_errors.clear();
    }
  }
  void kill() {
    if (!process) return;
    TerminateJobObject(job.get(), 1);
    WaitForSingleObject(process.get(), INFINITE);
    process.reset();
  }
};

Process::Process(const std::string& command) : running_(std::make_unique<Running>()) {
  Pipe input(false), output(true), errors(true);
  Inherited inherited({input.theirs.get(), output.theirs.get(), errors.theirs.get()});
  STARTUPINFOEXA start{};
  start.StartupInfo.cb = sizeof start;
  start.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
  start.StartupInfo.hStdInput = input.theirs.get();
  start.StartupInfo.hStdOutput = output.theirs.get();
  start.StartupInfo.hStdError = errors.theirs.get();
  start.lpAttributeList = inherited.list();
  running_->job.reset(made_job());
  std::string words = command, variables = environment();
  PROCESS_INFORMATION started{};
  // Suspended until it is in its job: what it starts is then in it, too. Ctrl+C does not reach a group of its own.
  constexpr DWORD how = CREATE_SUSPENDED | CREATE_NEW_PROCESS_GROUP | EXTENDED_STARTUPINFO_PRESENT;
  if (CreateProcessA(nullptr, words.data(), nullptr, nullptr, TRUE, how, variables.data(), nullptr, &start.StartupInfo,
                     &started) == 0) {
    const DWORD error = GetLastError();
    if (error != ERROR_FILE_NOT_FOUND && error != ERROR_PATH_NOT_FOUND) throw failure(command);
    running_->not_started = "exit code 127: " + command.substr(0, command.find(' ')) + ": not found";
    return;
  }
  running_->process.reset(started.hProcess);
  const Handle thread(started.hThread);
  if (AssignProcessToJobObject(running_->job.get(), started.hProcess) == 0) {
    const std::system_error why = failure("job");
    TerminateProcess(started.hProcess, 1);
    throw why;
  }
  ResumeThread(thread.get());
  running_->output.open(std::move(output.ours));
  running_->errors.open(std::move(errors.ours));
  running_->input.open(std::move(input.ours));
}

Process::~Process() = default;

void Process::wait_for(bool to_write, Clock::time_point deadline) {
  if (!running_->not_started.empty()) return;
  HANDLE streams[3] = {running_->output.event()};
  DWORD count = 1;
  if (running_->errors.is_open()) streams[count++] = running_->errors.event();
  if (running_->input.is_open() && (to_write || running_->input.is_closing()))
    streams[count++] = running_->input.event();
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  WaitForMultipleObjects(count, streams, FALSE, left.count() > 0 ? static_cast<DWORD>(left.count()) : 0);
  running_->read_errors();
  running_->input.advance();
}

void Process::write(std::string_view& outbox) { running_->input.write(outbox); }

void Process::close_input() { running_->input.close(); }

bool Process::read(std::string& inbox) { return running_->output.read(inbox); }

std::string Process::end() {
  if (!running_->not_started.empty()) return running_->not_started;
  DWORD code = 0;
  const bool ended = WaitForSingleObject(running_->process.get(), time_to_exit) == WAIT_OBJECT_0 &&
                     GetExitCodeProcess(running_->process.get(), &code) != 0;
  running_->kill();
  running_->read_errors();
  return running_->last_errors.after(ended ? ending(code) : "its output ended");
}

}  // namespace touchstone::audit
