// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

/// The mutants that survive so far.
namespace touchstone::mutation {

/// What is wrong with robust's answers; empty if nothing is.
using Complaint = std::function<std::string()>;

class Surviving {
 public:
  explicit Surviving(const std::string& numbers);  ///< "3,7,9"

  bool none() const { return numbers_.empty(); }
  /// Runs the baseline, which has no mutant, and then every surviving mutant; each run is a process of its own, so that
  /// nothing that robust remembers reaches another run. A complaint, crash or hang kills the mutant, and the line
  /// "killed 7 0.012" (number, seconds) on standard output says so. Returns whether the baseline passes; if it does
  /// not, its complaint is on standard error.
  bool run(const Complaint& complaint);

 private:
  std::vector<int> numbers_;
};

}  // namespace touchstone::mutation
