// SPDX-License-Identifier: Apache-2.0
// An engine that needs nothing of touchstone, to be built for two processors (docs/platforms.md). It reads its six
// numbers in the order in which touchstone writes them.
#include <charconv>
#include <iostream>
#include <string>

double side(const double (&c)[6]) { return (c[2] - c[0]) * (c[5] - c[1]) - (c[3] - c[1]) * (c[4] - c[0]); }

int main() {
  std::string line;
  std::getline(std::cin, line);
  std::cout << R"({"engine":"naive side","ops":["orientation"],"boundary":"closed"})" << std::endl;
  while (std::getline(std::cin, line)) {
    const std::size_t id = line.find("\"id\":") + 5;
    std::size_t at = line.find("\"input\":");
    double numbers[6];
    for (double& number : numbers) {
      do at = line.find_first_of("[,", at + 1);
      while (line[at + 1] == '"');
      std::from_chars(&line[at + 1], line.data() + line.size(), number);
    }
    const double s = side(numbers);
    std::cout << "{\"id\":" << line.substr(id, line.find_first_of(",}", id) - id) << ",\"answer\":{\"side\":\""
              << (s > 0   ? "left"
                  : s < 0 ? "right"
                          : "on")
              << "\"}}" << std::endl;
  }
}
