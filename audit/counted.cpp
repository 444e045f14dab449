// SPDX-License-Identifier: Apache-2.0
#include "audit/counted.h"

namespace touchstone::audit {

std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::string counted(std::uint64_t n, const std::string& noun) {
  return grouped(n) + " " + (n == 1 ? noun : noun == "vertex" ? "vertices" : noun + "s");
}

}  // namespace touchstone::audit
