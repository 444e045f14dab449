// SPDX-License-Identifier: Apache-2.0
#include "proptests/selftests/alive.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "proptests/selftests/mutant.h"

namespace touchstone::selftests {
namespace {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Whether the complaint comes, or the process dies, or takes longer than that.
bool killed(int number, const Complaint& complaint, unsigned longest) {
  const pid_t child = fork();
  if (child < 0) std::perror("fork"), std::_Exit(2);
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO), dup2(nowhere, STDERR_FILENO);
    alarm(longest);
    touchstone_mutant = number;
    try {
      _exit(complaint().empty() ? 0 : 1);
    } catch (...) {
      _exit(1);
    }
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child) std::perror("waitpid"), std::_Exit(2);
  return status != 0;
}

}  // namespace

Alive::Alive(const std::string& numbers) {
  std::istringstream text(numbers);
  for (std::string number; std::getline(text, number, ',');) numbers_.push_back(std::stoi(number));
}

std::string Alive::ask(const Complaint& complaint) {
  const double began = seconds();
  std::string said = complaint();
  const double calm = seconds() - began;
  std::fflush(nullptr);
  std::erase_if(numbers_, [&](int number) {
    const double asked = seconds();
    if (!killed(number, complaint, 3 + static_cast<unsigned>(3 * calm))) return false;
    std::printf("killed %d %.3f\n", number, seconds() - asked);
    return true;
  });
  std::fflush(stdout);
  return said;
}

}  // namespace touchstone::selftests
