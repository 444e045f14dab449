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

/// Whether nothing is said with that mutant on: no complaint, no crash, no hang. 0: without one, however long it takes.
bool silent(int number, const Complaint& complaint, unsigned longest) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) std::perror("fork"), std::_Exit(2);
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    if (number != 0) dup2(nowhere, STDERR_FILENO);
    alarm(longest);
    touchstone_mutant = number;
    try {
      const std::string said = complaint();
      std::fprintf(stderr, "%s%s", said.c_str(), said.empty() ? "" : "\n");
      _exit(said.empty() ? 0 : 1);
    } catch (...) {
      _exit(1);
    }
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child) std::perror("waitpid"), std::_Exit(2);
  return status == 0;
}

}  // namespace

Alive::Alive(const std::string& numbers) {
  std::istringstream text(numbers);
  for (std::string number; std::getline(text, number, ',');) numbers_.push_back(std::stoi(number));
}

bool Alive::ask(const Complaint& complaint) {
  const double began = seconds();
  const bool calm = silent(0, complaint, 0);
  const auto longest = static_cast<unsigned>(3 + 3 * (seconds() - began));
  std::erase_if(numbers_, [&](int number) {
    const double asked = seconds();
    if (silent(number, complaint, longest)) return false;
    std::printf("killed %d %.3f\n", number, seconds() - asked);
    return true;
  });
  return calm;
}

}  // namespace touchstone::selftests
