// SPDX-License-Identifier: Apache-2.0
// Test vectors from C++: consumer VECTORS prints the id of every vector that a function below gets wrong.
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
using Json = nlohmann::json;

static Json orientation(const Json& in) {
  const std::array<double, 2> p0 = in["p0"], p1 = in["p1"], p = in["p"];
  const double cross = (p1[0] - p0[0]) * (p[1] - p0[1]) - (p1[1] - p0[1]) * (p[0] - p0[0]);
  return {{"side", cross > 0 ? "left" : cross < 0 ? "right" : "on"}};
}
static Json line_point_at(const Json& in) {
  const std::array<double, 2> o = in["line"]["origin"], d = in["line"]["direction"];
  const double t = in["t"];
  return {{"point", {o[0] + t * d[0], o[1] + t * d[1]}}};
}
/// Words are equal; numbers are at most two units in the last place apart. "inf" is the double infinity.
static bool same(const Json& mine, const Json& right) {
  if (mine.is_structured()) return std::equal(mine.begin(), mine.end(), right.begin(), right.end(), same);
  if (!mine.is_number()) return mine == right;
  const double x = mine, y = right == "inf" ? INFINITY : right == "-inf" ? -INFINITY : right.get<double>();
  return x == y || (std::isfinite(y) && std::fabs(x - y) <= std::ldexp(2, std::max(std::ilogb(y), -1022) - 52));
}
int main(int, char** argv) {
  for (const auto& [name, answer] :
       std::map<std::string, Json (*)(const Json&)>{{"orientation", orientation}, {"line_point_at", line_point_at}}) {
    std::ifstream file(argv[1] + ("/" + name + ".jsonl"));
    int asked = 0, wrong = 0;
    for (std::string line; std::getline(file, line);) {
      const Json vector = Json::parse(line);
      if (vector.contains("refused")) continue;  // outside the contract: what you do there is yours to say
      ++asked;
      if (!same(answer(vector["input"]), vector["rounded"]) && ++wrong) std::cout << vector["id"] << '\n';
    }
    std::cout << name << ": " << asked << " asked, " << wrong << " wrong\n";
  }
}
