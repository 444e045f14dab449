// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

/// Mutants that nothing has killed yet, each asked in a process of its own.
namespace touchstone::selftests {

/// What is wrong with what robust answers; empty if nothing is.
using Complaint = std::function<std::string()>;

class Alive {
 public:
  explicit Alive(const std::string& numbers);  ///< "3,7,9"

  bool none() const { return numbers_.empty(); }
  /// Asks without a mutant, and then with each that is alive; every time in a process of its own, so that nothing
  /// robust remembers is another's. A complaint, a crash or a hang kills; whoever is killed is told on standard output,
  /// "killed 7 0.012" (number, seconds). Whether nothing was said without a mutant; what was, is on standard error.
  bool ask(const Complaint& complaint);

 private:
  std::vector<int> numbers_;
};

}  // namespace touchstone::selftests
