// SPDX-License-Identifier: Apache-2.0
#include "proptests/mutation/surviving.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "proptests/mutation/mutant.h"

namespace touchstone::mutation {
namespace {

constexpr int baseline = 0;  // the number of no mutant

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Whether that mutant survives: no complaint, no crash, no hang of more than `limit` seconds (0: no limit).
bool survives(int number, const Complaint& complaint, unsigned limit) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) std::perror("fork"), std::_Exit(2);
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    if (number != baseline) dup2(nowhere, STDERR_FILENO);
    alarm(limit);
    touchstone_mutant = number;
    try {
      const std::string found = complaint();
      std::fprintf(stderr, "%s%s", found.c_str(), found.empty() ? "" : "\n");
      _exit(found.empty() ? 0 : 1);
    } catch (...) {
      _exit(1);
    }
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child) std::perror("waitpid"), std::_Exit(2);
  return status == 0;
}

}  // namespace

Surviving::Surviving(const std::string& numbers) {
  std::istringstream text(numbers);
  for (std::string number; std::getline(text, number, ',');) numbers_.push_back(std::stoi(number));
}

bool Surviving::run(const Complaint& complaint) {
  const double began = seconds();
  const bool passes = survives(baseline, complaint, 0);
  const auto limit = static_cast<unsigned>(3 + 3 * (seconds() - began));
  std::erase_if(numbers_, [&](int number) {
    const double started = seconds();
    if (survives(number, complaint, limit)) return false;
    std::printf("killed %d %.3f\n", number, seconds() - started);
    return true;
  });
  return passes;
}

}  // namespace touchstone::mutation
